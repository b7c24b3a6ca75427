// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/basics/Effort.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

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

/// Triangles in patient space LPS, millimetres, in the precision that files of meshes have.
struct SurfaceMesh {
  std::vector<glm::vec3> points;
  std::vector<glm::vec3> normals;    ///< of the points, unit length, out of the higher values; or none
  std::vector<glm::uvec3> triangles; ///< anticlockwise seen from the side of the lower values
  bool operator==(const SurfaceMesh&) const = default;
};

/// How the triangles hang together, points at the same place being one.
struct EdgeCensus {
  std::uint64_t edges = 0;
  std::uint64_t usedOnce = 0; ///< the rims of holes
  std::uint64_t usedOtherwise =
      0; ///< by more than two triangles, or by two that are turned against each other
  /// Every edge is used by exactly two triangles, once in each direction.
  bool isWatertight() const { return edges > 0 && usedOnce == 0 && usedOtherwise == 0; }
};

/// Counts the edges; a watertight mesh has none but those that two triangles share.
EdgeCensus edgesOf(const SurfaceMesh& mesh);

/// The volume that the triangles enclose, mm³: the sum of tetrahedra (divergence theorem). Of meshes with
/// holes it means nothing.
double enclosedMm3(const SurfaceMesh& mesh);

/// Twice the area times the normal of a triangle, mm².
glm::dvec3 areaVector(const SurfaceMesh& mesh, const glm::uvec3& triangle);

/// The triangles whose flag is set, and the points that they use. `flags` has one for each triangle.
SurfaceMesh onlyTriangles(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& flags);

} // namespace limn
