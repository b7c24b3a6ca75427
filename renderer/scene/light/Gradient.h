// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/light/Shading.h"
#include "scene/volume/Volume.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>
#include <vector>

namespace limn {

/// The power of two, value/mm, in which moduli are computed: about the steepest that the volume can hold, so
/// that neither squares nor floats overflow or vanish, however large or small its values. Multiplying by it
/// is exact.
inline double modulusUnit(const Volume& volume) {
  const double steepest = (volume.range().highest - volume.range().lowest) / smallestSpacingMm(volume.grid());
  return std::ldexp(1.0, std::clamp(std::ilogb(steepest), -1000, 1000));
}

/// Voxels of one volume in their stored type, with differences in scalar units: the gradient of DEFINITION
/// section 2 along the grid's axes.
template <class T>
struct Stencil {
  const Volume& volume;
  const StoredVoxels<T>& stored;
  double perUnit = 1.0 / modulusUnit(volume);
  glm::ivec3 dims = volume.grid().dims;
  std::size_t stride[3] = {1, static_cast<std::size_t>(dims.x), static_cast<std::size_t>(dims.x) * dims.y};

  /// Derivative along one grid axis at a voxel, value/mm.
  double derivative(std::size_t offset, int index, int axis) const {
    const bool hasLower = index > 0;
    const bool hasUpper = index + 1 < dims[axis];
    const int distance = int(hasLower) + int(hasUpper);
    const double upper = static_cast<double>(stored[offset + (hasUpper ? stride[axis] : 0)]);
    const double lower = static_cast<double>(stored[offset - (hasLower ? stride[axis] : 0)]);
    if (upper == lower) // also along an axis of one voxel
      return 0.0;
    return volume.rescale().slope * (upper - lower) / (distance * volume.grid().spacingMm[axis]);
  }

  glm::dvec3 alongAxes(int i, int j, int k) const {
    const std::size_t offset = voxelOffset(dims, i, j, k);
    return {derivative(offset, i, 0), derivative(offset, j, 1), derivative(offset, k, 2)};
  }

  /// In units of `modulusUnit`.
  double modulus(int i, int j, int k) const { return glm::length(alongAxes(i, j, k) * perUnit); }
};

/// The voxels whose gradient counts: they and their stencil neighbours are valid (DEFINITION section 1). Told
/// of runs of at most 64 voxels along x at a time.
class EligibleVoxels {
public:
  static constexpr int run = 64;

  explicit EligibleVoxels(const Volume& volume) : m_mask(volume.invalidMask()), m_dims(volume.grid().dims) {}

  /// One bit for each of the `count` voxels from (x, y, z) on, the first the lowest.
  std::uint64_t from(int x, int y, int z, int count) const {
    const std::uint64_t asked = count == run ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
    if (m_mask.empty())
      return asked;
    const std::size_t row = m_dims.x;
    const std::size_t slice = row * m_dims.y;
    const std::size_t at = voxelOffset(m_dims, x, y, z);
    std::uint64_t invalid = m_mask.from(at);
    invalid |= invalid << 1 | (x > 0 && m_mask[at - 1] ? 1 : 0);
    std::uint64_t behind = m_mask.from(at + 1);
    if (x + count == m_dims.x)
      behind &= asked >> 1; // what follows the last is in another row
    invalid |= behind;
    if (y > 0)
      invalid |= m_mask.from(at - row);
    if (y + 1 < m_dims.y)
      invalid |= m_mask.from(at + row);
    if (z > 0)
      invalid |= m_mask.from(at - slice);
    if (z + 1 < m_dims.z)
      invalid |= m_mask.from(at + slice);
    return asked & ~invalid;
  }

  bool has(int x, int y, int z) const { return from(x, y, z, 1) != 0; }

private:
  const VoxelMask& m_mask;
  glm::ivec3 m_dims;
};

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

/// The moduli over the lattice, in units of `modulusUnit`, from which steepness is found.
struct LatticeModuli {
  std::vector<double> moduli;
  auto fields() { return std::tie(moduli); }
};

/// Of the voxels `of`; a volume that holds a part holds their neighbours, too.
LatticeModuli latticeModuli(const Volume& volume, const VoxelBox& of);

/// Of the voxels of both, which share none.
LatticeModuli joined(const LatticeModuli& a, const LatticeModuli& b);

/// The steepness of all voxels, of which these are the moduli in any order.
double steepness(const Volume& volume, LatticeModuli lattice);

/// The moduli that lighting needs: the largest, and the one that maps to r = 1; and whose gradients they are.
struct GradientScale {
  double largest = 0.0;
  double reference = 0.0;
  std::shared_ptr<const Volume> smoothed{}; ///< of smooth normals the smoothed volume; null: the volume's own
  bool operator==(const GradientScale&) const = default;
};

/// The shading's gradient reference with the automatic one replaced by the model's: the 99.5th percentile for
/// robust and physical, the largest modulus otherwise.
GradientReference resolvedReference(const Shading& shading);

/// Resolves the shading's gradient reference for a volume. Costs a pass over the volume: keep the result
/// while volume, model and reference stay.
GradientScale gradientScale(const Volume& volume, const Shading& shading, const Effort& effort = {});

} // namespace limn
