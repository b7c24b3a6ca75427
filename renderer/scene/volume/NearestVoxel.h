// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <optional>

namespace limn {

/// The voxel whose extent holds a continuous index, [v - 0.5, v + 0.5) on each axis; nothing outside the
/// grid, and of an index that is no number.
inline std::optional<glm::ivec3> nearestVoxel(const glm::dvec3& index, const glm::ivec3& dims) {
  const glm::dvec3 nearest = glm::floor(index + 0.5);
  const bool isInside = glm::all(glm::greaterThanEqual(nearest, glm::dvec3(0.0))) &&
                        glm::all(glm::lessThan(nearest, glm::dvec3(dims)));
  return isInside ? std::optional(glm::ivec3(nearest)) : std::nullopt;
}

} // namespace limn
