// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/chart/ChartValues.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double leastFloor = 0.0005;
constexpr double roomAtEnds = 0.06; ///< of the axis' length
constexpr double leastDecades = 0.6;

double errorOf(const ImageError& error, ErrorMeasure measure) {
  return measure == ErrorMeasure::mean ? error.mean : error.p99_9;
}

// A tolerance counts as the step that it replaces: larger is coarser.
double coarseness(const OperatingPoint& point) {
  return point.toleranceLevels.value_or(point.stepVoxels);
}

std::vector<double> ticksBetween(double lowest, double highest, const std::vector<double>& digits,
                                 int everyDecade) {
  std::vector<double> ticks;
  const int first = static_cast<int>(std::floor(std::log10(lowest)));
  const int last = static_cast<int>(std::ceil(std::log10(highest)));
  for (int decade = first; decade <= last; ++decade)
    for (const double digit : digits) {
      const double tick = digit * std::pow(10.0, decade);
      if (decade % everyDecade == 0 && tick >= lowest && tick <= highest)
        ticks.push_back(tick);
    }
  return ticks;
}

} // namespace

double chartFloor(const AccuracyReport& report, ErrorMeasure measure) {
  const double least =
      measure == ErrorMeasure::mean ? leastMean(report.reference) : leastP99_9(report.reference);
  return std::max(least, leastFloor);
}

std::vector<ChartCurve> chartCurves(const AccuracyReport& report, ErrorMeasure measure) {
  std::vector<ChartCurve> curves;
  if (!report.reference.converged)
    return curves;
  const double floor = chartFloor(report, measure);
  for (std::size_t i = 0; i < report.points.size(); ++i) {
    const MeasuredPoint& point = report.points[i];
    const std::string family = familyOf(point.point);
    auto curve = std::find_if(curves.begin(), curves.end(),
                              [&](const ChartCurve& known) { return known.family == family; });
    if (curve == curves.end())
      curve = curves.insert(curves.end(), ChartCurve{family, {}});
    const double error = errorOf(point.error, measure);
    curve->marks.push_back({i, point.ms.median, point.ms.least, point.ms.most, std::max(error, floor),
                            error < floor, point.isPareto});
  }
  for (ChartCurve& curve : curves)
    std::stable_sort(curve.marks.begin(), curve.marks.end(), [&](const ChartMark& a, const ChartMark& b) {
      return coarseness(report.points[a.index].point) > coarseness(report.points[b.index].point);
    });
  return curves;
}

LogAxis logAxisAround(double lowest, double highest, int most) {
  const double missing = std::max(0.0, leastDecades - std::log10(highest / lowest));
  const double room = missing / 2.0 + roomAtEnds * (std::log10(highest / lowest) + missing);
  LogAxis axis{lowest * std::pow(10.0, -room), highest * std::pow(10.0, room), {}};
  axis.ticks = ticksBetween(axis.lowest, axis.highest, {1.0, 2.0, 5.0}, 1);
  for (int every = 1; static_cast<int>(axis.ticks.size()) > most; ++every)
    axis.ticks = ticksBetween(axis.lowest, axis.highest, {1.0}, every);
  return axis;
}

} // namespace limn
