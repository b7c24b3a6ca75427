// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/AccuracySweep.h"

namespace limn {

/// A report whose errors and times follow simple laws, so that tests can say what to expect: rays err by
/// 8 · step² · 1.3 levels and take 12 + 9 / step ms, every other family differs by a factor of each, but
/// tolerances, which are kept with a fifth to spare in 30 + 20 / tolerance ms. Spreads are -5 % and +10 %.
/// The exact picture has converged to 0.004 level.
AccuracyReport sampleReport(const std::vector<OperatingPoint>& points);

/// A report of 4, 8 … 128 random paths a pixel, each in 50 ms, whose error is 80 / √n levels (99.9th
/// percentile; the mean a fifth of that), but of the fewest a tenth more.
AccuracyReport samplePathReport();

} // namespace limn
