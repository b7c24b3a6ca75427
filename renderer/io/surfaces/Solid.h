// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <cstdint>

namespace limn {

/// What a surface bounds: the points of the crop where the field reaches the isovalue and the kept region
/// weighs at least ½ (DEFINITION sections 1, 7 and 10). It shares the scene's volume. Positions are
/// continuous voxel indices.
class Solid {
public:
  Solid(const Scene& scene, double isovalue);

  const Volume& volume() const { return *m_volume; }
  double isovalue() const { return m_isovalue; }
  /// The crop within the volume box, which ends half a voxel beyond the outermost centres.
  const glm::dvec3& lower() const { return m_lower; }
  const glm::dvec3& upper() const { return m_upper; }
  glm::dvec3 withinCrop(const glm::dvec3& index) const { return glm::clamp(index, m_lower, m_upper); }
  bool isWholeVolumeKept() const { return !m_isRestricted; }

  /// How far the field lies above the isovalue, and the region's weight above ½.
  double excess(const glm::dvec3& index) const;
  double keeping(const glm::dvec3& index) const;

  bool contains(const glm::dvec3& index) const {
    return glm::all(glm::greaterThanEqual(index, m_lower)) && glm::all(glm::lessThanEqual(index, m_upper)) &&
           excess(index) >= 0.0 && (!m_isRestricted || keeping(index) >= 0.0);
  }

  /// Writes 1 for each of `count` voxels from (first, j, k) along x that the solid contains, else 0. They lie
  /// in the crop.
  void markRow(int first, int count, int j, int k, std::uint8_t* out) const;

  glm::dvec3 toIndex(const glm::dvec3& worldMm) const { return m_toIndex * (worldMm - m_originMm); }
  glm::dvec3 vectorToIndex(const glm::dvec3& vectorMm) const { return m_toIndex * vectorMm; }

private:
  std::shared_ptr<const Volume> m_volume;
  Region m_keep;
  std::vector<std::uint8_t> m_isKept; ///< of each label
  bool m_isRestricted;
  double m_isovalue;
  glm::dvec3 m_lower, m_upper, m_originMm;
  glm::dmat3 m_toIndex;
  double (*m_storedAt)(const VoxelArray& stored, const glm::ivec3& dims, const glm::dvec3& index);
};

} // namespace limn
