// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"

#include <algorithm>
#include <vector>

namespace limn {

/// The eight voxels around a position and its weights between them.
struct Cell {
  glm::ivec3 low{0};      ///< the voxel with the smallest indices
  glm::dvec3 weight{0.0}; ///< 0..1 towards low + 1
};

/// Reads a volume in its stored type: trilinear scalars and gradients in double (DEFINITION sections 1 and
/// 2).
template <class T>
class FieldSampler {
public:
  FieldSampler(const Volume& volume, const StoredVoxels<T>& stored)
      : m_stored(stored.data()), m_dims(volume.grid().dims), m_rescale(volume.rescale()),
        m_spacing(volume.grid().spacingMm), m_strideY(m_dims.x),
        m_strideZ(static_cast<std::ptrdiff_t>(m_dims.x) * m_dims.y) {}

  /// The cell of a continuous index, clamped to the outermost voxel centres.
  Cell cellAt(const glm::dvec3& index) const {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis) {
      const double p = std::clamp(index[axis], 0.0, m_dims[axis] - 1.0);
      cell.low[axis] = std::min(static_cast<int>(p), std::max(0, m_dims[axis] - 2));
      cell.weight[axis] = p - cell.low[axis];
    }
    return cell;
  }

  /// The scalar, interpolated trilinearly.
  double scalarAt(const Cell& cell) const {
    const std::ptrdiff_t x = m_dims.x > 1 ? 1 : 0;
    const std::ptrdiff_t y = m_dims.y > 1 ? m_strideY : 0;
    const std::ptrdiff_t z = m_dims.z > 1 ? m_strideZ : 0;
    const T* v = m_stored + offset(cell.low);
    const auto alongX = [&](const T* p) { return mix(double(p[0]), double(p[x]), cell.weight.x); };
    const auto alongY = [&](const T* p) { return mix(alongX(p), alongX(p + y), cell.weight.y); };
    return m_rescale.slope * mix(alongY(v), alongY(v + z), cell.weight.z) + m_rescale.intercept;
  }

  /// The gradient along the grid's axes, value/mm: voxel gradients interpolated trilinearly, which is the
  /// central difference of the interpolated field over an apron extrapolated linearly.
  glm::dvec3 gradientAt(const Cell& cell) const {
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis)
      gradient[axis] = m_dims[axis] > 1 ? derivativeAt(cell, axis) : 0.0;
    return gradient * m_rescale.slope;
  }

private:
  static double mix(double a, double b, double w) { return a + w * (b - a); }

  std::ptrdiff_t offset(const glm::ivec3& i) const { return i.x + i.y * m_strideY + i.z * m_strideZ; }

  std::ptrdiff_t stride(int axis) const { return axis == 0 ? 1 : axis == 1 ? m_strideY : m_strideZ; }

  // The derivative at voxel `index` of the line through p along an axis, stored value/mm.
  double difference(const T* p, int axis, int index) const {
    const std::ptrdiff_t step = stride(axis);
    const bool hasLower = index > 0;
    const bool hasUpper = index + 1 < m_dims[axis];
    const double upper = p[hasUpper ? step : 0];
    const double lower = p[hasLower ? -step : 0];
    return (upper - lower) / ((int(hasLower) + int(hasUpper)) * m_spacing[axis]);
  }

  double derivativeAt(const Cell& cell, int axis) const {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const std::ptrdiff_t alongU = m_dims[u] > 1 ? stride(u) : 0;
    const std::ptrdiff_t alongV = m_dims[v] > 1 ? stride(v) : 0;
    const T* low = m_stored + offset(cell.low);
    const auto along = [&](const T* p) {
      return mix(difference(p, axis, cell.low[axis]), difference(p + stride(axis), axis, cell.low[axis] + 1),
                 cell.weight[axis]);
    };
    const auto acrossU = [&](const T* p) { return mix(along(p), along(p + alongU), cell.weight[u]); };
    return mix(acrossU(low), acrossU(low + alongV), cell.weight[v]);
  }

  const T* m_stored;
  glm::ivec3 m_dims;
  Rescale m_rescale;
  glm::dvec3 m_spacing;
  std::ptrdiff_t m_strideY;
  std::ptrdiff_t m_strideZ;
};

} // namespace limn
