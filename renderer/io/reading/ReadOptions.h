// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/MemoryBudget.h"

#include <glm/glm.hpp>

#include <optional>

namespace limn {

/// What the person who opens a file adds to it.
struct ReadOptions {
  std::optional<glm::dvec3> spacingMm; ///< for image stacks and files without spacing; overrides otherwise
  std::optional<int> series;           ///< number of a series as listSeries gives it
  std::optional<MemoryBudget> memory;  ///< how much of it the process may take (default: MemoryBudget's)
};

} // namespace limn
