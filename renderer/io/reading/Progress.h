// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"

#include <functional>
#include <string>

namespace limn {

/// How long work reports and is stopped. Both functions may be empty and are called from the worker thread.
struct Progress {
  std::function<void(double fraction, const std::string& what)> report; ///< fraction 0..1
  std::function<bool()> isCancelled;                                    ///< true: throw Cancelled soon
};

/// Throws Cancelled where the caller asked to stop, otherwise reports how far the work is.
void reportOrStop(const Progress& progress, double fraction, const std::string& what);

/// The part of the progress that a step takes: its 0 is `from` of the whole, its 1 is `to`.
Progress part(const Progress& whole, double from, double to);

/// What is said while a volume is made of its voxels.
inline constexpr const char* countingVoxels = "Counting values";

/// Work on all cores that reports as `what`.
Effort effortOf(const Progress& progress, const std::string& what);

} // namespace limn
