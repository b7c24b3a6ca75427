// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/AccuracySweep.h"

#include <string>
#include <vector>

namespace limn {

/// Which figure of an error the chart shows.
enum class ErrorMeasure { p99_9, mean };

/// A measured point as the chart shows it.
struct ChartMark {
  std::size_t index = 0; ///< in the report's points
  double ms = 0.0;
  double leastMs = 0.0;
  double mostMs = 0.0;
  double error = 0.0;        ///< 8-bit levels, > 0; the floor where the error is below it
  bool isBelowFloor = false; ///< too small to be told from none: to be read as "< error"
  bool isPareto = false;
};

/// Points that differ in step or tolerance only, from coarse to fine.
struct ChartCurve {
  std::string family;
  std::vector<ChartMark> marks;
};

/// The smallest error that can be shown: what the exact picture allows, at least 0.0005 level.
double chartFloor(const AccuracyReport& report, ErrorMeasure measure);

/// One curve per family, in the report's order; none where the exact picture has not converged, because then
/// no error is known.
std::vector<ChartCurve> chartCurves(const AccuracyReport& report, ErrorMeasure measure);

/// A logarithmic axis with labelled places.
struct LogAxis {
  double lowest = 1.0; ///< > 0
  double highest = 10.0;
  std::vector<double> ticks; ///< 1, 2 and 5 times powers of ten, or powers of ten alone
};

/// An axis that shows `lowest`..`highest` (0 < lowest ≤ highest) with some room at both ends and at most
/// `most` ≥ 2 ticks.
LogAxis logAxisAround(double lowest, double highest, int most);

} // namespace limn
