// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "regions/BitGrid.h"

#include <functional>
#include <random>

namespace limn::test {

/// Calls `visit` with every voxel of a grid.
inline void forEachVoxel(const glm::ivec3& dims, const std::function<void(const glm::ivec3&)>& visit) {
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        visit({x, y, z});
}

/// The voxels of a grid for which `belongs` says so.
inline BitGrid setOf(const glm::ivec3& dims, const std::function<bool(const glm::ivec3&)>& belongs) {
  BitGrid set(dims);
  forEachVoxel(dims, [&](const glm::ivec3& voxel) {
    if (belongs(voxel))
      set.set(voxel);
  });
  return set;
}

/// Each voxel with the probability `share`.
inline BitGrid randomSet(const glm::ivec3& dims, double share, unsigned seed) {
  std::mt19937 random(seed);
  std::bernoulli_distribution coin(share);
  return setOf(dims, [&](const glm::ivec3&) { return coin(random); });
}

inline bool isInside(const glm::ivec3& dims, const glm::ivec3& voxel) {
  return glm::all(glm::greaterThanEqual(voxel, glm::ivec3(0))) && glm::all(glm::lessThan(voxel, dims));
}

/// Whether voxels are neighbours over a face, an edge or a corner.
inline const std::vector<glm::ivec3>& neighbours26() {
  static const std::vector<glm::ivec3> all = [] {
    std::vector<glm::ivec3> offsets;
    forEachVoxel({3, 3, 3}, [&](const glm::ivec3& voxel) {
      if (voxel != glm::ivec3(1))
        offsets.push_back(voxel - 1);
    });
    return offsets;
  }();
  return all;
}

/// What is connected with `seed` within a set, one voxel at a time.
inline BitGrid connectedWith(const BitGrid& set, const glm::ivec3& seed) {
  BitGrid found(set.dims());
  std::vector<glm::ivec3> toVisit{seed};
  found.set(seed);
  while (!toVisit.empty()) {
    const glm::ivec3 voxel = toVisit.back();
    toVisit.pop_back();
    for (const glm::ivec3& offset : neighbours26()) {
      const glm::ivec3 next = voxel + offset;
      if (!isInside(set.dims(), next) || !set.at(next) || found.at(next))
        continue;
      found.set(next);
      toVisit.push_back(next);
    }
  }
  return found;
}

/// The largest of the connected parts of a set, found one voxel at a time; the first of equal ones.
inline BitGrid largestPartOf(const BitGrid& set) {
  BitGrid left = set, largest(set.dims());
  forEachVoxel(set.dims(), [&](const glm::ivec3& voxel) {
    if (!left.at(voxel))
      return;
    const BitGrid part = connectedWith(left, voxel);
    left -= part;
    if (part.count() > largest.count())
      largest = part;
  });
  return largest;
}

} // namespace limn::test
