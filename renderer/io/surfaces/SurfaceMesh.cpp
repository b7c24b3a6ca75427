// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/SurfaceMesh.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>

namespace limn {
namespace {

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
