// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"

#include <algorithm>
#include <limits>

namespace limn {

/// What the points of a curve are over. Every curve is edited as a list of control points; this says what of
/// them counts.
enum class CurveSubject {
  value,   ///< opacity and colour over the scalar
  gradient ///< opacity over the modulus of the gradient: never below 0, without colours
};

inline bool hasColors(CurveSubject subject) {
  return subject == CurveSubject::value;
}

/// Below this no point lies.
inline double lowestPlace(CurveSubject subject) {
  return subject == CurveSubject::gradient ? 0.0 : -std::numeric_limits<double>::infinity();
}

/// The function with every point where it may lie.
inline TransferFunction limitedTo(CurveSubject subject, TransferFunction function) {
  for (ControlPoint& point : function.points)
    point.value = std::max(point.value, lowestPlace(subject));
  return function;
}

} // namespace limn
