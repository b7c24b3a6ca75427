// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace limn {

/// One picture of a renderer: its mean error in 8-bit levels and what it took of all threads.
struct ErrorAndTime {
  double meanError = 0.0;
  double cpuMs = 0.0;
};

/// The least processor time in which a renderer comes within an error: of pictures of several steps, by
/// linear interpolation between the logarithms of neighbours. Its coarsest picture where that is closer
/// already; absent where none is close enough.
std::optional<double> timeAtError(std::vector<ErrorAndTime> curve, double meanError);

/// Programs compared where they err alike.
struct EqualErrorRow {
  std::string scene;
  std::string program;
  double meanError = 0.0;      ///< levels
  std::optional<double> cpuMs; ///< absent: it never comes so close
  std::optional<double> gain;  ///< how many times faster than the yardstick; absent without either's time
  std::string yardstick;
};

} // namespace limn
