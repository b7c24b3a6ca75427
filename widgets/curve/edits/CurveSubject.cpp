// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/edits/CurveSubject.h"

#include <algorithm>

namespace limn {

TransferFunction limitedTo(CurveSubject subject, const TransferFunction& function) {
  TransferFunction limited = function;
  for (ControlPoint& point : limited.points)
    point.value = std::max(point.value, lowestPlace(subject));
  return limited;
}

} // namespace limn
