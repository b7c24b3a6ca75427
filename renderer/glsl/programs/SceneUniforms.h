// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gl/ShaderProgram.h"
#include "glsl/textures/SceneTextures.h"

namespace limn {

/// The texture units of the shaders' samplers.
enum class TextureUnit {
  volume,
  region,
  emptyDistance,
  blockSteps,
  functionBins,
  functionSegments,
  functionOccupancy,
  gradientBins,
  gradientSegments,
  functionTable,
  storedGradient,
  classifiedVolume,
  cellLooks,
  labels,
  directLight,
  ambientLight,
  smoothedVolume
};

/// Binds every texture to its unit.
void bindTextures(const SceneTextures& textures);

/// The most samples that one ray may take: `mostSamples`, less where each needs many steps through the
/// transfer function, because drivers limit the iterations of all loops together.
int sampleLimit(const Scene& scene, const SceneTextures& textures);

/// The unit of every length in the shaders, mm: the smallest spacing. Floats round the same whatever unit a
/// file has.
double lengthUnitMm(const Grid& grid);

/// What leads from a difference over two texels of a volume to the unit of gradients in the shaders, along
/// each axis.
glm::dvec3 differenceScale(const Grid& grid, const VolumeTexture& volume);

/// Sets every uniform of a program in use from the scene; those that the program has not are ignored. What
/// the shaders compute in float is converted here and nowhere else.
void setUniforms(const ShaderProgram& program, const Scene& scene, const glm::ivec2& size,
                 const SceneTextures& textures);

} // namespace limn
