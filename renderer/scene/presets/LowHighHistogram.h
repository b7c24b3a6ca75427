// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace limn {

/// What lies on the two sides of a place on a boundary, scalar units.
struct LowAndHigh {
  double low = 0.0;
  double high = 0.0;
  bool operator==(const LowAndHigh&) const = default;
};

/// Where many places agree.
struct LowHighPeak {
  LowAndHigh at;
  double share = 0.0; ///< of all places, 0..1
};

/// The peaks of a histogram of places, the largest first. Every place belongs to the one that is reached from
/// it by going up. The order of the places does not matter.
std::vector<LowHighPeak> peaksOf(std::vector<LowAndHigh> places);

} // namespace limn
