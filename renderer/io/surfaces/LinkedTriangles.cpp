// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/LinkedTriangles.h"

#include <algorithm>
#include <iterator>

namespace limn {

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

} // namespace limn
