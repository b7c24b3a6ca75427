// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/ShaderProgram.h"
#include "glsl/decisions/Decisions.h"
#include "scene/effects/EffectSet.h"

#include <string>
#include <vector>

namespace limn {

/// A file of the folder shaders, carried in the binary.
struct EmbeddedShader {
  std::string name;
  std::string text;
};

/// All of them, by names such as "march.glsl" and "decisions/volume_wide.glsl".
const std::vector<EmbeddedShader>& embeddedShaders();

/// The text of one file; it must exist.
const std::string& embeddedShader(const std::string& name);

/// The block by which a program lets the driver mix voxels.
const char* driverFilterBlock(const Decisions& decisions = {});

/// The vertex shader of every program.
ShaderSource vertexSource();

/// What tells a program of light on its way: nodes and what stands near a sample, or nodes alone (LightLook).
enum class LightFrom { nodesAndNear, nodesAlone };

/// The fragment shader of a canonical set of effects: a prelude of `#define`s and the building blocks that
/// the set calls for, in the order of the stage contract (shaders/README.md). Decisions other than the
/// program's own put blocks of shaders/decisions in the place of others.
ShaderSource fragmentSource(EffectSet effects, const Decisions& decisions = {},
                            LightFrom lightFrom = LightFrom::nodesAndNear);

/// The shaders of the slice renderer: the same blocks around another `main`.
ShaderSource sliceVertexSource();
ShaderSource sliceSource(EffectSet effects);

} // namespace limn
