// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

/// How a slider's track maps to numbers: 0 at its left end, 1 at its right; logarithmic where ratios matter.
struct SliderScale {
  double lowest = 0.0; ///< > 0 where logarithmic
  double highest = 1.0;
  bool logarithmic = false;
};

/// The place of a number on the track, limited to 0..1.
double fractionOf(const SliderScale& scale, double value);

/// The number at a place on the track; exact at both ends.
double valueAtFraction(const SliderScale& scale, double fraction);

} // namespace limn
