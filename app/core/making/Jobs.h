// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SweepFile.h"

#include <string>
#include <vector>

namespace limn {

/// One picture of a sweep: the words behind `limn` that draw it, and where it goes.
struct Job {
  std::vector<std::string> words;
  std::string picture;
};

/// The pictures of a sweep, in the order volume, preset, model, view, turn. A picture is called after what
/// tells it from the others: `head_ct-bone_classic_anterior_turn-07-of-36.png`. Paths are absolute, so that a
/// job runs from anywhere; one that is there and whole is not drawn again. Throws Error (usage) where there
/// is none, where two would have one name, or a name has a line break.
std::vector<Job> jobsOf(const Sweep& sweep);

/// Words as a POSIX shell takes them, on one line.
std::string shellLine(const std::string& program, const std::vector<std::string>& words);

} // namespace limn
