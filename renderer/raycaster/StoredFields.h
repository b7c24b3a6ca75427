// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glsl/decisions/Decisions.h"
#include "glsl/textures/TextureVoxels.h"
#include "glsl/textures/VoxelTexture.h"
#include "scene/function/TransferFunction.h"

namespace limn {

/// Gradients of texels made before drawing, and what one of the stored numbers means.
struct StoredGradients {
  VoxelTexture texture;
  double unitPerStored = 1.0; ///< of a component (halves) or of the modulus (directions)
};

/// `scale` leads from a difference over two texels to the unit of gradients in the shaders, whose components
/// then are at most 1. Halves are off by at most 2⁻¹¹ of a component (eleven binary digits) down to
/// components of 2⁻²⁹; what is interpolated are vectors, as DEFINITION section 2 asks. Directions are off by
/// at most 1/255 in each component, moduli by 1/510 of the largest; interpolated apart, a weak gradient turns
/// a strong neighbour's direction as much as that turns its own.
StoredGradients storedGradients(const TextureVoxels& voxels, const glm::dvec3& scale, GradientFormat format);

/// What the transfer function makes of each texel: colour times opacity, and opacity over the unit distance.
/// To be made anew with every change of the function.
VoxelTexture classifiedVolume(const TextureVoxels& voxels, const ValueRange& range,
                              const TransferFunction& function, ClassificationOrder order);

} // namespace limn
