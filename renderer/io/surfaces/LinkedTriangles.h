// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace limn {

/// Triangles that know their neighbours while edges are drawn together. Every point keeps a list of the
/// corners that lie on it.
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

} // namespace limn
