// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/basics/Message.h"

#include <functional>

namespace limn {

/// How long work reports and is stopped. Both functions may be empty and are called from the worker thread.
struct Progress {
  std::function<void(double fraction, const Message& what)> report; ///< fraction 0..1
  std::function<bool()> isCancelled;                                ///< true: throw Cancelled soon
};

/// Throws Cancelled where the caller asked to stop, otherwise reports how far the work is.
void reportOrStop(const Progress& progress, double fraction, const Message& what);

/// The part of the progress that a step takes: its 0 is `from` of the whole, its 1 is `to`.
Progress part(const Progress& whole, double from, double to);

/// What is said while a volume is made of its voxels.
inline const Message countingVoxels = Message::tr("Counting values");

/// Work on all cores that reports as `what`.
Effort effortOf(const Progress& progress, const Message& what);

} // namespace limn
