// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace limn {

/// How far random paths are in a picture of physical light (DEFINITION section 12).
struct PathFigures {
  int paths = 0; ///< that every covered pixel had at least
  /// The standard errors of pixels, in 255 levels after tone and encoding: their root mean square, and what
  /// 99.9 % of the colours keep below. Absent before there are two paths to compare.
  std::optional<double> rmsLevels, p99_9Levels;
  /// Beside those: their mean and largest, and of the covered pixels the share, 0..1, of which one exceeds 1.
  double meanLevels{}, largestLevels{}, shareOverOne{};
  bool operator==(const PathFigures&) const = default;
};

/// What filtering the noise of random paths did to a picture, 255 levels of display colours.
struct NoiseFigures {
  double rmsChange{}, largestChange{};
  /// The error that is left, its root mean square, judged by paths that the filter did not see. Absent where
  /// there are too few.
  std::optional<double> rmsLevels;
};

} // namespace limn
