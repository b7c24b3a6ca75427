// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"
#include "scene/basics/MemoryBudget.h"

namespace limn {

/// Draws on `threads` of the processor (0: all) in single precision. Needs no OpenGL. What stands in for a
/// volume that does not lie in memory keeps to a share of the budget.
std::unique_ptr<DrawingEngine> makeCpuEngine(int threads = 0, const MemoryBudget& budget = MemoryBudget());

} // namespace limn
