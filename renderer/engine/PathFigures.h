// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

namespace limn {

/// What filtering the noise of random paths changed in a picture, 255 levels of display colours.
struct NoiseFigures {
  double rmsChange{}, largestChange{};
  bool operator==(const NoiseFigures&) const = default;
};

/// How far random paths are in a picture of physical light (DEFINITION section 12).
struct PathFigures {
  int paths = 0; ///< that every covered pixel had at least
  /// The standard errors of pixels, in 255 levels after tone and encoding: their root mean square, and what
  /// 99.9 % of the colours keep below. Absent before there are two paths to compare. Of a picture whose noise
  /// was filtered the former is the error that is left, as far as paths tell it that the filter did not see;
  /// the latter is not known.
  std::optional<double> rmsLevels, p99_9Levels;
  /// Beside those: their mean and largest, and of the covered pixels the share, 0..1, of which one exceeds 1.
  double meanLevels{}, largestLevels{}, shareOverOne{};
  std::optional<NoiseFigures> filtered{}; ///< absent where noise was not filtered
  bool operator==(const PathFigures&) const = default;
};

} // namespace limn
