// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/Axes.h"

#include "widgets/ValueText.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double roomAtEnds = 0.06; ///< of a logarithmic axis' length
constexpr double leastDecades = 0.6;

// Lines of one pixel are sharp in its middle.
double onPixel(double place) {
  return std::round(place) + 0.5;
}

std::vector<AxisTick> powersBetween(const ValueRange& range, const std::vector<double>& digits,
                                    int everyDecade) {
  std::vector<AxisTick> ticks;
  const int first = static_cast<int>(std::floor(std::log10(range.lowest)));
  const int last = static_cast<int>(std::ceil(std::log10(range.highest)));
  for (int decade = first; decade <= last; ++decade)
    for (const double digit : digits) {
      const double value = digit * std::pow(10.0, decade);
      if (decade % everyDecade == 0 && value >= range.lowest && value <= range.highest)
        ticks.push_back({value, plainNumber(value, std::max(0, -decade))});
    }
  return ticks;
}

} // namespace

std::vector<AxisTick> linearTicks(const ValueRange& range, int most) {
  const double least = (range.highest - range.lowest) / most;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  double step = 10.0 * power;
  for (const double multiple : {5.0, 2.0, 1.0})
    if (multiple * power >= least)
      step = multiple * power;

  std::vector<AxisTick> ticks;
  // Count in whole steps, so that no rounding error adds up.
  const double last = std::floor(range.highest / step);
  for (double i = std::ceil(range.lowest / step); i <= last; i += 1.0)
    ticks.push_back({i * step, valueText(i * step, {}, decimalsFor(step))});
  return ticks;
}

std::vector<AxisTick> logarithmicTicks(const ValueRange& range, int most) {
  std::vector<AxisTick> ticks = powersBetween(range, {1.0, 2.0, 5.0}, 1);
  for (int every = 1; static_cast<int>(ticks.size()) > most; ++every)
    ticks = powersBetween(range, {1.0}, every);
  return ticks;
}

ValueRange logarithmicRange(double lowest, double highest) {
  const double missing = std::max(0.0, leastDecades - std::log10(highest / lowest));
  const double room = missing / 2.0 + roomAtEnds * (std::log10(highest / lowest) + missing);
  return {lowest * std::pow(10.0, -room), highest * std::pow(10.0, room)};
}

void paintAxisAcross(QPainter& painter, const PlotTransform& transform, const std::vector<AxisTick>& ticks,
                     const QString& title, const std::vector<QRectF>& lanes, double top, double height,
                     const AxisColors& colors) {
  const QRectF& plot = transform.plot;
  const double titleWidth =
      title.isEmpty() ? 0.0 : painter.fontMetrics().horizontalAdvance(title) + 0.5 * height;
  painter.setPen(colors.title);
  painter.drawText(QRectF(plot.right() - titleWidth, top, titleWidth, height),
                   Qt::AlignRight | Qt::AlignVCenter, title);
  for (const AxisTick& tick : ticks) {
    const double x = onPixel(xOfValue(transform, tick.value));
    const double half = painter.fontMetrics().horizontalAdvance(tick.text) / 2.0;
    if (titleWidth > 0.0 && x + half > plot.right() - titleWidth)
      continue; // a line without its number tells nothing
    painter.setPen(colors.grid);
    for (const QRectF& lane : lanes)
      painter.drawLine(QPointF(x, lane.top()), QPointF(x, lane.bottom()));
    painter.setPen(colors.numbers);
    painter.drawText(QRectF(std::max(x, half) - 60.0, top, 120.0, height), Qt::AlignCenter, tick.text);
  }
}

void paintAxisUp(QPainter& painter, const PlotTransform& transform, const std::vector<AxisTick>& ticks,
                 const QString& title, double titleX, double gap, const AxisColors& colors) {
  const QRectF& plot = transform.plot;
  const QFontMetricsF metrics(painter.font());
  double lastY = 1e9;
  for (const AxisTick& tick : ticks) {
    const double y = onPixel(yOfOpacity(transform, tick.value));
    painter.setPen(colors.grid);
    painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    if (lastY - y < 0.85 * metrics.height())
      continue;
    lastY = y;
    painter.setPen(colors.numbers);
    painter.drawText(QRectF(0.0, y - metrics.height(), plot.left() - gap, 2.0 * metrics.height()),
                     Qt::AlignRight | Qt::AlignVCenter, tick.text);
  }
  painter.save();
  painter.translate(titleX, plot.center().y());
  painter.rotate(-90.0);
  painter.setPen(colors.title);
  const double length = plot.height() + 4.0 * gap;
  painter.drawText(QRectF(-length / 2.0, -metrics.height(), length, 2.0 * metrics.height()), Qt::AlignCenter,
                   metrics.elidedText(title, Qt::ElideRight, length));
  painter.restore();
}

} // namespace limn
