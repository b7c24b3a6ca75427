// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/ShaderProgram.h"
#include "glsl/decisions/Decisions.h"
#include "scene/effects/EffectSet.h"

namespace limn {

/// The vertex shader of every program.
ShaderSource vertexSource();

/// The fragment shader of a canonical set of effects: a prelude of `#define`s and the building blocks that
/// the set calls for, in the order of the stage contract (shaders/README.md). Decisions other than the
/// program's own put blocks of shaders/decisions in the place of others.
ShaderSource fragmentSource(EffectSet effects, const Decisions& decisions = {});

/// The shaders of the slice renderer: the same blocks around another `main`.
ShaderSource sliceVertexSource();
ShaderSource sliceSource(EffectSet effects);

} // namespace limn
