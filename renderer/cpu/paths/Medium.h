// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/paths/PathTerms.h"
#include "scene/basics/StableMath.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace limn::cpu {

/// The texels of the segment of a table that holds x (scene/function/PiecewiseTable).
inline const glm::vec4* segmentAt(const PiecewiseTable& table, float x) {
  const float place = std::clamp((x - table.domain.x) * table.domain.y, 0.0f, table.domain.z);
  const glm::vec4& bin = table.bins[static_cast<std::size_t>(place)];
  const std::size_t segment =
      static_cast<std::size_t>(bin.w) + (x >= bin.y ? 1u : 0u) + (x >= bin.z ? 1u : 0u);
  const glm::vec4* texels = &table.segments[4 * segment];
  while (x >= texels[2].y)
    texels += 4;
  return texels;
}

/// The opacity that a table tells of x, 0..1.
inline float opacityOf(const PiecewiseTable& table, float x) {
  const glm::vec4* texels = segmentAt(table, x);
  return std::clamp(texels[0].a + (x - texels[2].x) * texels[1].a, 0.0f, 1.0f);
}

/// Voxels of one stored type between their centres.
template <class T>
class VoxelField {
public:
  explicit VoxelField(const VoxelSource& source)
      : m_begin(source.begin), m_last(glm::max(source.dims - 1, 0)), m_strideX(source.dims.x > 1 ? 1 : 0),
        m_strideY(source.strideY), m_strideZ(source.strideZ), m_scale(source.scale), m_shift(source.shift) {}

  /// The eight voxels around a place.
  struct Cell {
    const T* at;
    glm::ivec3 low;
    glm::vec3 within;
  };

  Cell cellAt(const glm::vec3& place) const {
    const glm::vec3 p = glm::clamp(place, glm::vec3(0.0f), glm::vec3(m_last));
    const glm::ivec3 low = glm::min(glm::ivec3(p), glm::max(m_last - 1, 0));
    return {reinterpret_cast<const T*>(m_begin + low.y * m_strideY + low.z * m_strideZ) + low.x, low,
            p - glm::vec3(low)};
  }

  /// Normalised, trilinear.
  float scalarAt(const Cell& cell) const {
    const T* v = cell.at;
    const auto alongX = [&](const T* p) {
      const float a = static_cast<float>(p[0]), b = static_cast<float>(p[m_strideX]);
      return a + cell.within.x * (b - a);
    };
    const auto alongY = [&](const T* p) {
      const float a = alongX(p), b = alongX(moved(p, m_strideY));
      return a + cell.within.y * (b - a);
    };
    const float a = alongY(v), b = alongY(moved(v, m_strideZ));
    return m_scale * (a + cell.within.z * (b - a)) + m_shift;
  }

  /// Differences of voxels over two of them along each axis, in stored units; those at the border count
  /// twice, being over one (DEFINITION section 2).
  glm::vec3 differencesAt(const Cell& cell) const {
    return {differenceAt<0>(cell), differenceAt<1>(cell), differenceAt<2>(cell)};
  }

private:
  static const T* moved(const T* p, std::int64_t bytes) {
    return reinterpret_cast<const T*>(reinterpret_cast<const unsigned char*>(p) + bytes);
  }
  std::int64_t bytesAlong(int axis) const {
    return axis == 0 ? m_strideX * std::int64_t{sizeof(T)} : axis == 1 ? m_strideY : m_strideZ;
  }

  float difference(const T* p, int axis, int index) const {
    const std::int64_t step = bytesAlong(axis);
    const bool hasLower = index > 0;
    const bool hasUpper = index < m_last[axis];
    const float upper = static_cast<float>(*moved(p, hasUpper ? step : 0));
    const float lower = static_cast<float>(*moved(p, hasLower ? -step : 0));
    return hasLower && hasUpper ? upper - lower : 2.0f * (upper - lower);
  }

  template <int axis>
  float differenceAt(const Cell& cell) const {
    if (m_last[axis] == 0)
      return 0.0f;
    constexpr int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto along = [&](const T* p) {
      const float a = difference(p, axis, cell.low[axis]);
      const float b = difference(moved(p, bytesAlong(axis)), axis, cell.low[axis] + 1);
      return a + cell.within[axis] * (b - a);
    };
    const auto acrossU = [&](const T* p) {
      const float a = along(p), b = along(moved(p, bytesAlong(u)));
      return a + cell.within[u] * (b - a);
    };
    const float a = acrossU(cell.at), b = acrossU(moved(cell.at, bytesAlong(v)));
    return a + cell.within[v] * (b - a);
  }

  const unsigned char* m_begin;
  glm::ivec3 m_last;
  std::int64_t m_strideX, m_strideY, m_strideZ;
  float m_scale, m_shift;
};

/// What the curve, the kept region and the looks of labels make of a volume: extinctions and colours
/// (DEFINITION sections 3, 10 and 12).
template <class T>
class Medium {
public:
  explicit Medium(const PathTerms& terms) : m_terms(terms), m_field(terms.voxels) {}

  /// Per length.
  float extinctionAt(const glm::vec3& place) const {
    const auto cell = m_field.cellAt(place);
    const float scalar = m_field.scalarAt(cell);
    if (m_terms.looks)
      return std::min(mixedAt(place, scalar, factorAt(place, cell)).w, mostExtinction);
    float opacity = opacityOf(*m_terms.function, scalar);
    if (!(opacity > 0.0f))
      return 0.0f;
    if (m_terms.hasRegion)
      opacity *= weightAt(place);
    if (m_terms.gradientCurve)
      opacity *= factorAt(place, cell);
    return std::min(extinctionOf(opacity) * m_terms.perUnitDistance, mostExtinction);
  }

  /// The albedo of what is met at a place where there is something: its colour, linear.
  glm::vec3 albedoAt(const glm::vec3& place) const {
    const auto cell = m_field.cellAt(place);
    const float scalar = m_field.scalarAt(cell);
    if (m_terms.looks)
      return linear(glm::vec3(mixedAt(place, scalar, factorAt(place, cell))));
    const glm::vec4* texels = segmentAt(*m_terms.function, scalar);
    return linear(glm::vec3(texels[0]) + (scalar - texels[2].x) * glm::vec3(texels[1]));
  }

  /// In ranges per length, along the grid's axes; of the smoothed field where normals are smoothed.
  glm::vec3 gradientAt(const glm::vec3& place) const { return gradientAt(place, m_field.cellAt(place)); }

private:
  // From a half on 1 - opacity is exact, and its logarithm is had in less time.
  static float extinctionOf(float opacity) {
    const float limited = std::min(opacity, static_cast<float>(largestOpacity));
    return limited >= 0.5f ? -std::log(1.0f - limited) : -std::log1p(-limited);
  }

  using Cell = typename VoxelField<T>::Cell;

  glm::vec3 gradientAt(const glm::vec3& place, const Cell& cell) const {
    if (!m_terms.smoothsNormals)
      return m_field.differencesAt(cell) * m_terms.gradientScale;
    const VoxelField<float> smoothed(m_terms.smoothed);
    return smoothed.differencesAt(smoothed.cellAt(place)) * m_terms.gradientScale;
  }

  float factorAt(const glm::vec3& place, const Cell& cell) const {
    return m_terms.gradientCurve ? opacityOf(*m_terms.gradientCurve, glm::length(gradientAt(place, cell)))
                                 : 1.0f;
  }

  float weightAt(const glm::vec3& place) const {
    if (m_terms.region.kind == VoxelSource::Kind::byte) {
      const VoxelField<std::uint8_t> field(m_terms.region);
      return field.scalarAt(field.cellAt(place));
    }
    const VoxelField<std::uint16_t> field(m_terms.region);
    return field.scalarAt(field.cellAt(place));
  }

  // What the looks of the voxels around a place make together: colour, and extinction per length.
  glm::vec4 mixedAt(const glm::vec3& place, float scalar, float factor) const {
    const double width = m_terms.range.highest - m_terms.range.lowest;
    const double value = m_terms.range.lowest + double(scalar) * (width > 0.0 ? width : 1.0);
    glm::vec4 mixed(0.0f);
    const LookShares shares = lookSharesAt(*m_terms.looks, *m_terms.keep, glm::dvec3(place));
    for (const LookShare& one : shares.used()) {
      const Classified classified = classify(m_terms.looks->functions[one.look], value);
      const float extinction = static_cast<float>(one.share * minusLog1mOpacity(one.weight * double(factor) *
                                                                                classified.opacity)) *
                               m_terms.perUnitOfLooks[one.look];
      mixed += glm::vec4(extinction * glm::vec3(classified.color), extinction);
    }
    if (mixed.w > 0.0f)
      mixed = glm::vec4(glm::vec3(mixed) / mixed.w, mixed.w);
    return mixed;
  }

  float linear(float encoded) const {
    const float place = std::clamp(encoded, 0.0f, 1.0f) * PathTerms::linearSteps;
    const auto step = static_cast<std::size_t>(place);
    const float within = place - static_cast<float>(step);
    return m_terms.linear[step] + within * (m_terms.linear[step + 1] - m_terms.linear[step]);
  }
  glm::vec3 linear(const glm::vec3& color) const {
    return {linear(color.r), linear(color.g), linear(color.b)};
  }

  const PathTerms& m_terms;
  VoxelField<T> m_field;
};

} // namespace limn::cpu
