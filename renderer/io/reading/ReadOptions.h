// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <optional>

namespace limn {

/// What the person who opens a file adds to it.
struct ReadOptions {
  std::optional<glm::dvec3> spacingMm; ///< for image stacks and files without spacing; overrides otherwise
  std::optional<int> series;           ///< number of a series as listSeries gives it
};

} // namespace limn
