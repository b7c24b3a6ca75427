// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/Decimation.h"

#include "scene/volume/Grid.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <queue>
#include <vector>

namespace limn {
namespace {

// The squared distances of a point to planes, each weighted by an area (M. Garland, P. Heckbert, "Surface
// Simplification Using Quadric Error Metrics", SIGGRAPH 1997): xᵀAx - 2bᵀx + c.
struct Quadric {
  glm::dmat3 a{0.0};
  glm::dvec3 b{0.0};
  double c = 0.0;

  static Quadric ofPlane(const glm::dvec3& normal, const glm::dvec3& point, double area) {
    const double offset = glm::dot(normal, point);
    return {area * glm::outerProduct(normal, normal), area * offset * normal, area * offset * offset};
  }
  Quadric operator+(const Quadric& other) const { return {a + other.a, b + other.b, c + other.c}; }

  double at(const glm::dvec3& x) const {
    return std::max(0.0, glm::dot(x, a * x) - 2.0 * glm::dot(b, x) + c);
  }
  /// Of all planes; their normals have unit length.
  double area() const { return a[0][0] + a[1][1] + a[2][2]; }

  /// Where the sum is least; nothing where the planes do not fix a point well.
  std::optional<glm::dvec3> least() const {
    const double third = area() / 3.0, determinant = glm::determinant(a);
    constexpr double leastShare = 1e-5; // of the determinant of planes in all directions
    if (!(determinant > leastShare * third * third * third))
      return std::nullopt;
    return glm::inverse(a) * b;
  }
};

// Triangles that know their neighbours while edges are drawn together. Every point keeps a list of the
// corners that lie on it.
class LinkedTriangles {
public:
  LinkedTriangles(const std::vector<glm::uvec3>& triangles, std::size_t points);

  std::size_t count() const { return m_triangles.size(); }
  const std::vector<glm::uvec3>& triangles() const { return m_triangles; }
  const std::vector<std::uint8_t>& flags() const { return m_isThere; } ///< 0 of those that are gone
  const glm::uvec3& corners(std::uint32_t triangle) const { return m_triangles[triangle]; }
  bool has(std::uint32_t triangle, std::uint32_t point) const {
    const glm::uvec3& t = m_triangles[triangle];
    return t.x == point || t.y == point || t.z == point;
  }

  /// Whether the point lies on an edge that not exactly two triangles use.
  bool isOnRim(std::uint32_t point) const { return m_isOnRim[point]; }

  /// Whether `holds(triangle)` does for all triangles around a point.
  template <class Predicate>
  bool allAround(std::uint32_t point, Predicate&& holds) const {
    for (std::uint32_t corner = m_first[point]; corner != none; corner = m_next[corner])
      if (m_isThere[corner / 3] && !holds(corner / 3))
        return false;
    return true;
  }

  /// The points that share an edge with one, each once, in ascending order.
  void findNeighbours(std::uint32_t point, std::vector<std::uint32_t>& found) const;

  /// Whether drawing the edge together leaves every edge with two triangles (the link condition: the ends
  /// share no neighbours but those across the edge) and no two triangles on top of each other.
  bool mayBeDrawnTogether(std::uint32_t a, std::uint32_t b);

  /// Makes one point of both, which is `a`; the triangles at the edge go.
  void drawTogether(std::uint32_t a, std::uint32_t b);

private:
  static constexpr std::uint32_t none = 0xFFFFFFFF;

  void findRims();

  std::vector<glm::uvec3> m_triangles;
  std::vector<std::uint8_t> m_isThere;
  std::vector<std::uint32_t> m_first; ///< of each point the first corner on it
  std::vector<std::uint32_t> m_next;  ///< of each corner (3 · triangle + which) the next on the same point
  std::vector<std::uint8_t> m_isOnRim;
  std::vector<std::uint32_t> m_ofA, m_ofB, m_shared, m_across; ///< room that millions of questions share
};

LinkedTriangles::LinkedTriangles(const std::vector<glm::uvec3>& triangles, std::size_t points)
    : m_triangles(triangles), m_isThere(triangles.size(), 1), m_first(points, none),
      m_next(3 * triangles.size(), none), m_isOnRim(points, 0) {
  for (std::uint32_t triangle = 0; triangle < m_triangles.size(); ++triangle)
    for (std::uint32_t side = 0; side < 3; ++side) {
      std::uint32_t& first = m_first[m_triangles[triangle][side]];
      m_next[3 * triangle + side] = first;
      first = 3 * triangle + side;
    }
  findRims();
}

// Around a point inside the surface each neighbour is met once as the next corner and once as the one before.
void LinkedTriangles::findRims() {
  std::vector<std::uint32_t> next, before;
  for (std::uint32_t point = 0; point < m_first.size(); ++point) {
    next.clear();
    before.clear();
    for (std::uint32_t corner = m_first[point]; corner != none; corner = m_next[corner]) {
      next.push_back(m_triangles[corner / 3][(corner + 1) % 3]);
      before.push_back(m_triangles[corner / 3][(corner + 2) % 3]);
    }
    std::sort(next.begin(), next.end());
    std::sort(before.begin(), before.end());
    m_isOnRim[point] = next != before || std::adjacent_find(next.begin(), next.end()) != next.end();
  }
}

void LinkedTriangles::findNeighbours(std::uint32_t point, std::vector<std::uint32_t>& found) const {
  found.clear();
  allAround(point, [&](std::uint32_t triangle) {
    for (int side = 0; side < 3; ++side)
      if (m_triangles[triangle][side] != point)
        found.push_back(m_triangles[triangle][side]);
    return true;
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

bool LinkedTriangles::mayBeDrawnTogether(std::uint32_t a, std::uint32_t b) {
  findNeighbours(a, m_ofA);
  findNeighbours(b, m_ofB);
  m_shared.clear();
  std::set_intersection(m_ofA.begin(), m_ofA.end(), m_ofB.begin(), m_ofB.end(), std::back_inserter(m_shared));
  // The new point is left with three triangles at least, and so are those across the edge.
  if (m_shared.size() != 2 || m_ofA.size() + m_ofB.size() < 7)
    return false;
  return std::all_of(m_shared.begin(), m_shared.end(), [this](std::uint32_t point) {
    findNeighbours(point, m_across);
    return m_across.size() > 3;
  });
}

void LinkedTriangles::drawTogether(std::uint32_t a, std::uint32_t b) {
  for (std::uint32_t corner = m_first[b]; corner != none; corner = m_next[corner])
    if (has(corner / 3, a))
      m_isThere[corner / 3] = 0;
    else
      m_triangles[corner / 3][corner % 3] = a;
  // Both lists become one, of the corners that are left.
  std::uint32_t joined = none;
  for (const std::uint32_t point : {a, b})
    for (std::uint32_t corner = m_first[point], next = none; corner != none; corner = next) {
      next = m_next[corner];
      if (!m_isThere[corner / 3])
        continue;
      m_next[corner] = joined;
      joined = corner;
    }
  m_first[a] = joined;
  m_first[b] = none;
}

// Points between those that are tried may lie a little farther away.
constexpr double shareOfTolerance = 0.8;
// A triangle may turn so far (cosine) and be so thin (height over its longest side).
constexpr double leastTurn = 0.3;
constexpr double thinnest = 0.02;

/// An edge that may be drawn together, while neither of its points has changed.
struct Candidate {
  float cost = 0.0F;
  std::uint32_t a = 0, b = 0;
  std::uint32_t changesOfA = 0, changesOfB = 0;
  bool operator<(const Candidate& other) const {
    return std::tie(other.cost, other.a, other.b) < std::tie(cost, a, b); // the least comes first
  }
};

/// Whether triangles lie near the boundary of a solid.
class NearBoundary {
public:
  NearBoundary(const Solid& solid, double toleranceMm)
      : m_solid(solid), m_toleranceMm(toleranceMm), m_voxelMm(smallestSpacingMm(solid.volume().grid())) {}

  // From each point tried the boundary is met within the tolerance: outwards where the point lies in the
  // solid, inwards where it lies outside. Inwards beyond a face of the crop, the face counts.
  bool has(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const {
    const glm::dvec3 normal = glm::normalize(glm::cross(b - a, c - a));
    const glm::dvec3 away = m_solid.vectorToIndex(m_toleranceMm * normal);
    const glm::dvec3 from = m_solid.toIndex(a), toB = m_solid.toIndex(b) - from,
                     toC = m_solid.toIndex(c) - from;
    const double longest = std::max({glm::length(b - a), glm::length(c - a), glm::length(c - b)});
    const int steps = std::max(2, static_cast<int>(std::ceil(longest / m_voxelMm)));
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) {
        const glm::dvec3 at = from + (1.0 * i * toB + 1.0 * j * toC) / (1.0 * steps);
        const bool isNear = m_solid.contains(at) ? !m_solid.contains(at + away)
                                                 : m_solid.contains(m_solid.withinCrop(at - away));
        if (!isNear)
          return false;
      }
    return true;
  }

private:
  const Solid& m_solid;
  double m_toleranceMm;
  double m_voxelMm;
};

class Decimation {
public:
  Decimation(const SurfaceMesh& mesh, const Solid& solid, double toleranceMm);
  void run(const Progress& progress);
  SurfaceMesh result() const;

private:
  void offer(std::uint32_t a, std::uint32_t b);
  glm::dvec3 bestPlace(std::uint32_t a, std::uint32_t b, const Quadric& sum) const;
  bool mayMeetAt(std::uint32_t a, std::uint32_t b, const glm::dvec3& place);
  bool keepsTriangles(std::uint32_t moved, std::uint32_t other, const glm::dvec3& place) const;
  bool staysNear(std::uint32_t moved, std::uint32_t other, const glm::dvec3& place) const;
  void drawTogether(std::uint32_t a, std::uint32_t b, const glm::dvec3& place);
  std::array<glm::dvec3, 3> cornersWith(std::uint32_t triangle, std::uint32_t moved,
                                        const glm::dvec3& place) const;

  std::vector<glm::dvec3> m_points;
  LinkedTriangles m_links;
  NearBoundary m_near;
  double m_toleranceMm;
  std::vector<Quadric> m_quadrics;
  std::vector<std::uint32_t> m_changes; ///< of each point
  std::priority_queue<Candidate> m_queue;
  std::vector<std::uint32_t> m_around; ///< the last point that was moved
};

Decimation::Decimation(const SurfaceMesh& mesh, const Solid& solid, double toleranceMm)
    : m_points(mesh.points.begin(), mesh.points.end()), m_links(mesh.triangles, mesh.points.size()),
      m_near(solid, shareOfTolerance * toleranceMm), m_toleranceMm(toleranceMm),
      m_quadrics(mesh.points.size()), m_changes(mesh.points.size()) {
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::dvec3 twice = areaVector(mesh, triangle);
    const double size = glm::length(twice);
    if (!(size > 0.0))
      continue;
    const Quadric plane = Quadric::ofPlane(twice / size, m_points[triangle.x], size / 2.0);
    for (int corner = 0; corner < 3; ++corner)
      m_quadrics[triangle[corner]] = m_quadrics[triangle[corner]] + plane;
  }
  // Each edge is met twice, from either side.
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int side = 0; side < 3; ++side)
      if (triangle[side] < triangle[(side + 1) % 3])
        offer(triangle[side], triangle[(side + 1) % 3]);
}

glm::dvec3 Decimation::bestPlace(std::uint32_t a, std::uint32_t b, const Quadric& sum) const {
  const glm::dvec3 middle = 0.5 * (m_points[a] + m_points[b]);
  if (const auto least = sum.least())
    if (glm::length(*least - middle) <= glm::length(m_points[a] - m_points[b]))
      return *least;
  const std::array<glm::dvec3, 3> places{middle, m_points[a], m_points[b]};
  return *std::min_element(places.begin(), places.end(), [&](const glm::dvec3& one, const glm::dvec3& other) {
    return sum.at(one) < sum.at(other);
  });
}

void Decimation::offer(std::uint32_t a, std::uint32_t b) {
  if (m_links.isOnRim(a) || m_links.isOnRim(b))
    return;
  const Quadric sum = m_quadrics[a] + m_quadrics[b];
  const double squared = sum.at(bestPlace(a, b, sum)) / std::max(sum.area(), 1e-300);
  if (squared > m_toleranceMm * m_toleranceMm)
    return;
  // Where all is flat, short edges come first.
  const double length = glm::length(m_points[a] - m_points[b]);
  m_queue.push({static_cast<float>(squared + 1e-6 * length * length), a, b, m_changes[a], m_changes[b]});
}

std::array<glm::dvec3, 3> Decimation::cornersWith(std::uint32_t triangle, std::uint32_t moved,
                                                  const glm::dvec3& place) const {
  std::array<glm::dvec3, 3> corners;
  for (int corner = 0; corner < 3; ++corner) {
    const std::uint32_t point = m_links.corners(triangle)[corner];
    corners[corner] = point == moved ? place : m_points[point];
  }
  return corners;
}

bool Decimation::keepsTriangles(std::uint32_t moved, std::uint32_t other, const glm::dvec3& place) const {
  return m_links.allAround(moved, [&](std::uint32_t triangle) {
    if (m_links.has(triangle, other))
      return true;
    const auto [a, b, c] = cornersWith(triangle, moved, place);
    const auto [oldA, oldB, oldC] = cornersWith(triangle, moved, m_points[moved]);
    const glm::dvec3 now = glm::cross(b - a, c - a), before = glm::cross(oldB - oldA, oldC - oldA);
    const double size = glm::length(now);
    const double longest = std::max({glm::dot(b - a, b - a), glm::dot(c - a, c - a), glm::dot(c - b, c - b)});
    return size > thinnest * longest && glm::dot(now, before) >= leastTurn * size * glm::length(before);
  });
}

bool Decimation::staysNear(std::uint32_t moved, std::uint32_t other, const glm::dvec3& place) const {
  return m_links.allAround(moved, [&](std::uint32_t triangle) {
    const auto [a, b, c] = cornersWith(triangle, moved, place);
    return m_links.has(triangle, other) || m_near.has(a, b, c);
  });
}

bool Decimation::mayMeetAt(std::uint32_t a, std::uint32_t b, const glm::dvec3& place) {
  return m_links.mayBeDrawnTogether(a, b) && keepsTriangles(a, b, place) && keepsTriangles(b, a, place) &&
         staysNear(a, b, place) && staysNear(b, a, place);
}

void Decimation::drawTogether(std::uint32_t a, std::uint32_t b, const glm::dvec3& place) {
  m_points[a] = place;
  m_quadrics[a] = m_quadrics[a] + m_quadrics[b];
  m_links.drawTogether(a, b);
  ++m_changes[a];
  ++m_changes[b];
  m_links.findNeighbours(a, m_around);
  for (const std::uint32_t neighbour : m_around)
    offer(a, neighbour);
}

void Decimation::run(const Progress& progress) {
  const Message what = Message::tr("Taking away triangles");
  const std::size_t triangles = std::max<std::size_t>(m_links.count(), 1);
  for (std::size_t tried = 0; !m_queue.empty(); ++tried) {
    // Each triangle's edges are tried about four times in all.
    if (tried % 4096 == 0)
      reportOrStop(progress, std::min(0.99, 0.25 * static_cast<double>(tried) / triangles), what);
    const Candidate candidate = m_queue.top();
    m_queue.pop();
    if (m_changes[candidate.a] != candidate.changesOfA || m_changes[candidate.b] != candidate.changesOfB)
      continue;
    const glm::dvec3 place =
        bestPlace(candidate.a, candidate.b, m_quadrics[candidate.a] + m_quadrics[candidate.b]);
    if (mayMeetAt(candidate.a, candidate.b, place))
      drawTogether(candidate.a, candidate.b, place);
  }
}

SurfaceMesh Decimation::result() const {
  SurfaceMesh mesh;
  mesh.points.assign(m_points.begin(), m_points.end());
  mesh.triangles = m_links.triangles();
  return onlyTriangles(mesh, m_links.flags());
}

} // namespace

SurfaceMesh decimated(const SurfaceMesh& mesh, const Solid& solid, double toleranceMm,
                      const Progress& progress) {
  Decimation decimation(mesh, solid, toleranceMm);
  decimation.run(progress);
  return decimation.result();
}

} // namespace limn
