// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/StatedAccuracy.h"

#include <cmath>

namespace limn {

PictureAccuracy accuracyByChance(const ErrorByChance& error) {
  return {error.levels, describe(error).english(), {}};
}

PictureAccuracy accuracyByEstimate(double levels) {
  constexpr double white = 255.0; // which an estimate may exceed, and no picture
  if (!(levels <= white))
    levels = white;
  // Rounded up, as what is promised.
  const std::string told = Message::fixed(std::ceil(100.0 * levels) / 100.0, 2).english();
  return {levels,
          "99.9 % of the pixels are estimated to lie within " + told + " of 255 levels of the exact picture.",
          {}};
}

} // namespace limn
