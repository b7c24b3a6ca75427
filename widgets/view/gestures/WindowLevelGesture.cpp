// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/WindowLevelGesture.h"

#include <algorithm>
#include <cmath>

namespace limn {

FunctionWindow windowOf(const TransferFunction& function, const ValueRange& range) {
  double lowest = range.lowest;
  double highest = range.highest;
  if (!function.points.empty() && function.points.front().value < function.points.back().value) {
    lowest = function.points.front().value;
    highest = function.points.back().value;
  }
  return {0.5 * (lowest + highest), highest - lowest};
}

TransferFunction windowLevelDragged(const TransferFunction& start, const ValueRange& range,
                                    const QPointF& moved) {
  const FunctionWindow window = windowOf(start, range);
  // A factor beyond e^±6 only collapses the points or sends them out of every volume's range.
  const double factor = std::exp(std::clamp(moved.x() / 256.0, -6.0, 6.0));
  const double offset = -moved.y() / 256.0 * window.width;
  return shifted(stretched(start, window.level, factor), offset);
}

TransferFunction opacityDragged(const TransferFunction& start, const QPointF& moved) {
  return withOpacityScaled(start, std::exp2(std::clamp(-moved.y() / 100.0, -20.0, 20.0)));
}

} // namespace limn
