// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/light/Shading.h"
#include "scene/volume/Volume.h"

namespace limn {

/// The gradient at voxel (i, j, k), value/mm in world axes: central differences, one-sided over the real
/// distance at the border, 0 along an axis of one voxel (DEFINITION section 2; paper eq. 5 with the sign and
/// the spacing put right).
glm::dvec3 gradientAtVoxel(const Volume& volume, const glm::ivec3& index);

/// The gradient at a continuous index: the voxel gradients interpolated trilinearly, clamped to the edge.
glm::dvec3 gradientAt(const Volume& volume, const glm::dvec3& index);

/// The largest gradient modulus over the eligible voxels, value/mm; 0 where none is eligible. A voxel is
/// eligible if it and its stencil neighbours are valid.
double largestGradient(const Volume& volume, const Effort& effort = {});

/// The nearest-rank percentile (0..100] of the gradient modulus over the eligible voxels: the exact element,
/// rounded to float; at 100 the largest itself.
double gradientPercentile(const Volume& volume, double percent, const Effort& effort = {});

/// What the field commonly changes by at most, value/mm: the 99th percentile of the gradient modulus over a
/// lattice of at most 32 voxels along each axis. A quick look, for choosing between methods.
double steepness(const Volume& volume);

/// The moduli that lighting needs: the largest, and the one that maps to r = 1.
struct GradientScale {
  double largest = 0.0;
  double reference = 0.0;
  bool operator==(const GradientScale&) const = default;
};

/// The shading's gradient reference with the automatic one replaced by the model's: the 99.5th percentile for
/// robust, the largest modulus otherwise.
GradientReference resolvedReference(const Shading& shading);

/// Resolves the shading's gradient reference for a volume. Costs a pass over the volume: keep the result
/// while volume, model and reference stay.
GradientScale gradientScale(const Volume& volume, const Shading& shading, const Effort& effort = {});

} // namespace limn
