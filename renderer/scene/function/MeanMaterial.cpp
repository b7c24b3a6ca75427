// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/function/MeanMaterial.h"

#include "scene/basics/StableMath.h"

namespace limn {

glm::dvec4 meanOfPiece(const Classified& from, const Classified& to) {
  const Classified& faint = from.opacity <= to.opacity ? from : to;
  const Classified& dense = from.opacity <= to.opacity ? to : from;
  const double low = std::clamp(faint.opacity, 0.0, largestOpacity);
  const double high = std::clamp(dense.opacity, low, largestOpacity);
  // -log(1-a) along the piece is its value at the faint end and that of the rest, relative to what is left.
  const double share = (high - low) / (1.0 - low);
  const double extinction = minusLog1mOpacity(low);
  const double mean = extinction + meanMinusLog1m(share);
  const double moment = 0.5 * extinction + momentMinusLog1m(share);
  return {faint.color * (mean - moment) + dense.color * moment, mean};
}

MeanMaterial meanMaterial(const TransferFunction& function, double a, double b) {
  const double low = std::min(a, b);
  const double high = std::max(a, b);
  glm::dvec4 mean(0.0);
  Classified from = classify(function, low);
  if (!(high > low)) {
    mean = meanOfPiece(from, from);
  } else {
    // Go from knot to knot; the piece before a step ends at the step's first point.
    double start = low;
    for (const ControlPoint& point : function.points) {
      if (point.value <= low || point.value > high)
        continue;
      mean += (point.value - start) * meanOfPiece(from, {point.color, point.opacity});
      from = {point.color, point.opacity};
      start = point.value;
    }
    mean += (high - start) * meanOfPiece(from, classify(function, high));
    mean /= high - low;
  }
  return {mean.a, mean.a > 0.0 ? glm::dvec3(mean) / mean.a : glm::dvec3(0.0)};
}

} // namespace limn
