// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/SurfaceMesh.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace limn {
namespace {

// Stored values between voxel centres, whose type is known: millions of places are asked for.
template <class Stored>
double storedBetween(const VoxelArray& array, const glm::ivec3& dims, const glm::dvec3& index) {
  const auto& stored = *std::get_if<StoredVoxels<Stored>>(&array);
  const glm::dvec3 p = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(dims - 1));
  const glm::ivec3 low(p);
  const glm::dvec3 share = p - glm::dvec3(low);
  const std::size_t right = low.x + 1 < dims.x ? 1 : 0;
  const std::size_t below = low.y + 1 < dims.y ? static_cast<std::size_t>(dims.x) : 0;
  const std::size_t behind = low.z + 1 < dims.z ? static_cast<std::size_t>(dims.x) * dims.y : 0;
  const Stored* at = stored.data() + voxelOffset(dims, low.x, low.y, low.z);
  const auto alongX = [&](std::size_t from) {
    return static_cast<double>(at[from]) * (1.0 - share.x) + static_cast<double>(at[from + right]) * share.x;
  };
  const double front = alongX(0) * (1.0 - share.y) + alongX(below) * share.y;
  const double back = alongX(behind) * (1.0 - share.y) + alongX(behind + below) * share.y;
  return front * (1.0 - share.z) + back * share.z;
}

// A number for each point, the same for those at the same place.
std::vector<std::uint32_t> placesOf(const std::vector<glm::vec3>& points) {
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto key = [&](std::uint32_t i) { return std::tie(points[i].x, points[i].y, points[i].z); };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<std::uint32_t> places(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    places[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? places[order[i - 1]] : order[i];
  return places;
}

} // namespace

Solid::Solid(const Scene& scene, double isovalue)
    : m_volume(scene.volume), m_keep(scene.keep), m_isRestricted(isRestricting(scene.keep)),
      m_isovalue(isovalue) {
  const Grid& grid = m_volume->grid();
  const glm::dvec3 size(grid.dims);
  m_lower = scene.crop.lower * size - 0.5;
  m_upper = scene.crop.upper * size - 0.5;
  m_originMm = grid.originMm;
  for (int column = 0; column < 3; ++column) {
    glm::dvec3 unit(0.0);
    unit[column] = 1.0;
    m_toIndex[column] = worldVectorToIndex(grid, unit);
  }
  for (const double weight : m_keep.weights)
    m_isKept.push_back(weight >= 0.5 ? 1 : 0);
  m_storedAt = visitVoxels(*m_volume,
                           []<class Stored>(const StoredVoxels<Stored>&) { return &storedBetween<Stored>; });
}

double Solid::excess(const glm::dvec3& index) const {
  const Rescale& rescale = m_volume->rescale();
  return rescale.slope * m_storedAt(m_volume->stored(), m_volume->grid().dims, index) + rescale.intercept -
         m_isovalue;
}

double Solid::keeping(const glm::dvec3& index) const {
  return weightAt(m_keep, index) - 0.5;
}

void Solid::markRow(int first, int count, int j, int k, std::uint8_t* out) const {
  const std::size_t row = voxelOffset(m_volume->grid().dims, first, j, k);
  const Rescale rescale = m_volume->rescale();
  visitVoxels(*m_volume, [&](const auto& stored) {
    for (int i = 0; i < count; ++i)
      out[i] = rescale.slope * static_cast<double>(stored[row + i]) + rescale.intercept - m_isovalue >= 0.0;
  });
  if (m_isRestricted)
    for (int i = 0; i < count; ++i)
      out[i] &= m_isKept[m_keep.labels->placeAt(row + i)];
}

EdgeCensus edgesOf(const SurfaceMesh& mesh) {
  // Both ends, the lower first, and which way the triangle goes; fewer than 2³¹ points fit.
  std::vector<std::uint64_t> uses;
  uses.reserve(3 * mesh.triangles.size());
  const std::vector<std::uint32_t> places = placesOf(mesh.points);
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int side = 0; side < 3; ++side) {
      const std::uint64_t from = places[triangle[side]], to = places[triangle[(side + 1) % 3]];
      uses.push_back(std::min(from, to) << 32 | std::max(from, to) << 1 | (from < to ? 1 : 0));
    }
  std::sort(uses.begin(), uses.end());
  EdgeCensus census;
  for (std::size_t first = 0, end = 0; first < uses.size(); first = end) {
    while (end < uses.size() && uses[end] >> 1 == uses[first] >> 1)
      ++end;
    ++census.edges;
    if (end - first == 1)
      ++census.usedOnce;
    else if (end - first != 2 || uses[first] == uses[first + 1])
      ++census.usedOtherwise;
  }
  return census;
}

double enclosedMm3(const SurfaceMesh& mesh) {
  if (mesh.points.empty())
    return 0.0;
  const glm::dvec3 centre(mesh.points.front());
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangles)
    sum += glm::dot(glm::dvec3(mesh.points[t.x]) - centre,
                    glm::cross(glm::dvec3(mesh.points[t.y]) - centre, glm::dvec3(mesh.points[t.z]) - centre));
  return sum / 6.0;
}

glm::dvec3 areaVector(const SurfaceMesh& mesh, const glm::uvec3& triangle) {
  const glm::dvec3 corner(mesh.points[triangle.x]);
  return glm::cross(glm::dvec3(mesh.points[triangle.y]) - corner,
                    glm::dvec3(mesh.points[triangle.z]) - corner);
}

SurfaceMesh onlyTriangles(const SurfaceMesh& mesh, const std::vector<std::uint8_t>& flags) {
  constexpr auto unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> places(mesh.points.size(), unused);
  SurfaceMesh kept;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!flags[i])
      continue;
    glm::uvec3 triangle;
    for (int corner = 0; corner < 3; ++corner) {
      const std::uint32_t point = mesh.triangles[i][corner];
      if (places[point] == unused) {
        places[point] = static_cast<std::uint32_t>(kept.points.size());
        kept.points.push_back(mesh.points[point]);
        if (!mesh.normals.empty())
          kept.normals.push_back(mesh.normals[point]);
      }
      triangle[corner] = places[point];
    }
    kept.triangles.push_back(triangle);
  }
  return kept;
}

} // namespace limn
