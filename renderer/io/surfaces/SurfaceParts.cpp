// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/SurfaceParts.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace limn {
namespace {

/// Points that triangles join (union by the lower number, paths halved).
class JoinedPoints {
public:
  explicit JoinedPoints(std::size_t count) : m_above(count) { std::iota(m_above.begin(), m_above.end(), 0u); }
  std::uint32_t rootOf(std::uint32_t point) {
    while (m_above[point] != point)
      point = m_above[point] = m_above[m_above[point]];
    return point;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = rootOf(a);
    b = rootOf(b);
    m_above[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::uint32_t> m_above;
};

} // namespace

SurfaceParts partsOf(const SurfaceMesh& mesh) {
  JoinedPoints joined(mesh.points.size());
  for (const glm::uvec3& triangle : mesh.triangles) {
    joined.join(triangle.x, triangle.y);
    joined.join(triangle.y, triangle.z);
  }
  constexpr auto unknown = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> partOfRoot(mesh.points.size(), unknown);
  SurfaceParts parts;
  parts.ofTriangle.reserve(mesh.triangles.size());
  std::vector<glm::dvec3> origins;
  for (const glm::uvec3& t : mesh.triangles) {
    std::uint32_t& part = partOfRoot[joined.rootOf(t.x)];
    if (part == unknown) {
      part = static_cast<std::uint32_t>(origins.size());
      origins.emplace_back(mesh.points[t.x]);
      parts.enclosedMm3.push_back(0.0);
    }
    parts.ofTriangle.push_back(part);
    const glm::dvec3& origin = origins[part];
    const glm::dvec3 a(mesh.points[t.x]), b(mesh.points[t.y]), c(mesh.points[t.z]);
    parts.enclosedMm3[part] += glm::dot(a - origin, glm::cross(b - origin, c - origin)) / 6.0;
  }
  return parts;
}

std::vector<std::uint8_t> largeParts(const SurfaceParts& parts, double leastMm3, DroppedParts& dropped) {
  dropped = {};
  std::vector<std::uint8_t> isLarge;
  for (const double enclosed : parts.enclosedMm3) {
    isLarge.push_back(std::abs(enclosed) >= leastMm3);
    if (isLarge.back())
      continue;
    ++(enclosed < 0.0 ? dropped.hollows : dropped.parts);
    dropped.enclosedMm3 += std::max(0.0, enclosed);
  }
  std::vector<std::uint8_t> flags;
  flags.reserve(parts.ofTriangle.size());
  for (const std::uint32_t part : parts.ofTriangle)
    flags.push_back(isLarge[part]);
  return flags;
}

} // namespace limn
