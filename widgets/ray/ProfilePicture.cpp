// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/ray/ProfilePicture.h"

#include "widgets/ValueText.h"
#include "widgets/controls/color/ColorConversion.h"

#include <QObject>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double laneTextHeight = 18.0;
constexpr double laneGap = 6.0;
constexpr double axisHeight = 20.0;
constexpr double axisSideRoom = 10.0;
constexpr double pixelsPerDepth = 64.0;

// The crosshair's, as in slices and picture.
const QColor crosshairColor(77, 163, 255);

// What of a ray falls into one column of pixels.
struct ProfileColumn {
  double lowest = 0.0, highest = 0.0; ///< values
  double opacity = 0.0;               ///< the largest
  double contribution = 0.0;          ///< per mm, the largest
  QColor opacityColor, contributionColor;
};

void take(ProfileColumn& column, const RayProfile::Sample& sample) {
  column.lowest = std::min(column.lowest, sample.value);
  column.highest = std::max(column.highest, sample.value);
  if (sample.opacityPerMm >= column.opacity) {
    column.opacity = sample.opacityPerMm;
    column.opacityColor = toQColor(sample.color);
  }
  if (contributionPerMm(sample) >= column.contribution) {
    column.contribution = contributionPerMm(sample);
    column.contributionColor = toQColor(sample.color);
  }
}

std::vector<ProfileColumn> columnsOf(const ProfilePicture& picture) {
  const PlotTransform& depths = picture.depths;
  const auto& samples = picture.profile.samples;
  std::vector<ProfileColumn> columns;
  for (int i = 0; i < static_cast<int>(depths.plot.width()); ++i) {
    const double from = valueAtX(depths, depths.plot.left() + i);
    const double to = valueAtX(depths, depths.plot.left() + i + 1.0);
    const RayProfile::Sample& middle = sampleAt(picture.profile, (from + to) / 2.0);
    ProfileColumn column{middle.value, middle.value, 0.0, 0.0, {}, {}};
    // A surface takes no length: it shows in its own column, not in all that it is nearest to.
    if (middle.lengthMm > 0.0)
      take(column, middle);
    auto sample = std::ranges::lower_bound(samples, from, {}, &RayProfile::Sample::depthMm);
    for (; sample != samples.end() && sample->depthMm < to; ++sample)
      take(column, *sample);
    columns.push_back(column);
  }
  return columns;
}

void paintLaneFrame(QPainter& painter, const ProfilePicture& picture, const QRectF& lane,
                    const LaneText& text) {
  painter.fillRect(lane, picture.colors.base);
  const QRectF line(lane.left(), lane.top() - laneTextHeight, lane.width(), laneTextHeight);
  painter.setPen(picture.colors.text);
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, text.title);
  const double room = line.width() - painter.fontMetrics().horizontalAdvance(text.title) - 12.0;
  painter.setPen(picture.colors.secondaryText);
  if (painter.fontMetrics().horizontalAdvance(text.range) <= room)
    painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, text.range);
}

void paintDepthAxis(QPainter& painter, const ProfilePicture& picture) {
  const QRectF& plot = picture.depths.plot;
  const AxisTicks ticks =
      niceTicks(picture.depths.visible, std::max(2, static_cast<int>(plot.width() / pixelsPerDepth)));
  const QString title = picture.names.depthUnit.isEmpty()
                            ? QObject::tr("deep")
                            : QObject::tr("%1 deep").arg(picture.names.depthUnit);
  const double titleWidth = painter.fontMetrics().horizontalAdvance(title) + 8.0;
  painter.setPen(picture.colors.secondaryText);
  painter.drawText(QRectF(plot.right() - titleWidth, plot.bottom(), titleWidth, axisHeight),
                   Qt::AlignRight | Qt::AlignVCenter, title);
  for (const double depth : ticks.values) {
    const double x = std::round(xOfValue(picture.depths, depth)) + 0.5;
    painter.setPen(picture.colors.grid);
    for (const QRectF& lane : lanesOf(plot))
      painter.drawLine(QPointF(x, lane.top()), QPointF(x, lane.bottom()));
    const QString text = valueText(depth, {}, decimalsFor(ticks.step));
    const double width = painter.fontMetrics().horizontalAdvance(text);
    if (x + width / 2.0 > plot.right() - titleWidth)
      continue;
    painter.setPen(picture.colors.secondaryText);
    const double left = std::max(plot.left(), x - width / 2.0);
    painter.drawText(QRectF(left, plot.bottom(), width + 2.0, axisHeight), Qt::AlignLeft | Qt::AlignVCenter,
                     text);
  }
}

void paintValues(QPainter& painter, const ProfilePicture& picture, const QRectF& lane,
                 const std::vector<ProfileColumn>& columns) {
  const ValueRange values = valuesOf(picture.profile);
  const double span = values.highest > values.lowest ? values.highest - values.lowest : 1.0;
  const auto yOf = [&](double value) {
    return lane.bottom() - 2.0 - (value - values.lowest) / span * (lane.height() - 4.0);
  };
  QPolygonF line;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double x = lane.left() + static_cast<double>(i) + 0.5;
    line << QPointF(x, yOf(columns[i].lowest));
    if (columns[i].highest > columns[i].lowest)
      line << QPointF(x, yOf(columns[i].highest));
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(picture.colors.curve, 1.5));
  painter.drawPolyline(line);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

// Bars in the colours of the tissue below a line that stands out from them.
void paintBars(QPainter& painter, const ProfilePicture& picture, const QRectF& lane,
               const std::vector<double>& heights, const std::vector<QColor>& colors, double most) {
  QPolygonF edge;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double x = lane.left() + static_cast<double>(i);
    const double height = most > 0.0 ? heights[i] / most * (lane.height() - 2.0) : 0.0;
    if (height > 0.0)
      painter.fillRect(QRectF(x, lane.bottom() - height, 1.0, height), colors[i]);
    edge << QPointF(x + 0.5, lane.bottom() - height - 0.5);
  }
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(picture.colors.curve, 1.0));
  painter.drawPolyline(edge);
  painter.setRenderHint(QPainter::Antialiasing, false);
}

void paintDepth(QPainter& painter, const ProfilePicture& picture, double depth, const QPen& pen) {
  const QRectF& plot = picture.depths.plot;
  const double x = std::round(xOfValue(picture.depths, depth)) + 0.5;
  if (x < plot.left() || x > plot.right())
    return;
  painter.setPen(pen);
  for (const QRectF& lane : lanesOf(plot))
    painter.drawLine(QPointF(x, lane.top()), QPointF(x, lane.bottom()));
}

// "½" on a plate at the foot of its line.
void paintHalf(QPainter& painter, const ProfilePicture& picture) {
  paintDepth(painter, picture, *picture.half, QPen(picture.colors.accent, 2.0));
  const QRectF lane = lanesOf(picture.depths.plot).back();
  const double x = xOfValue(picture.depths, *picture.half);
  if (x < lane.left() || x > lane.right())
    return;
  const QSizeF size(18.0, 18.0);
  QRectF plate(QPointF(x + 3.0, lane.top() + 3.0), size);
  if (plate.right() > lane.right())
    plate.moveRight(x - 3.0);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(picture.colors.accent);
  painter.drawRoundedRect(plate, 3.0, 3.0);
  painter.setPen(picture.colors.accentText);
  painter.drawText(plate, Qt::AlignCenter, QStringLiteral("½"));
  painter.setRenderHint(QPainter::Antialiasing, false);
}

} // namespace

QRectF profilePlot(const QSizeF& size) {
  return {axisSideRoom, 0.0, std::max(20.0, size.width() - 2.0 * axisSideRoom),
          std::max(20.0, size.height() - axisHeight)};
}

std::array<QRectF, 3> lanesOf(const QRectF& plot) {
  const double height = std::max(4.0, (plot.height() - 2.0 * laneGap) / 3.0 - laneTextHeight);
  std::array<QRectF, 3> lanes;
  for (std::size_t i = 0; i < lanes.size(); ++i)
    lanes[i] =
        QRectF(plot.left(),
               plot.top() + laneTextHeight + static_cast<double>(i) * (height + laneTextHeight + laneGap),
               plot.width(), height);
  return lanes;
}

void paintProfile(QPainter& painter, const ProfilePicture& picture) {
  painter.setRenderHint(QPainter::Antialiasing, false);
  const std::array<QRectF, 3> lanes = lanesOf(picture.depths.plot);
  const std::array<LaneText, 3> texts = laneTexts(picture.profile, picture.names);
  for (std::size_t i = 0; i < lanes.size(); ++i)
    paintLaneFrame(painter, picture, lanes[i], texts[i]);
  paintDepthAxis(painter, picture);
  const std::vector<ProfileColumn> columns = columnsOf(picture);
  paintValues(painter, picture, lanes[0], columns);
  std::vector<double> opacities, contributions;
  std::vector<QColor> opacityColors, contributionColors;
  for (const ProfileColumn& column : columns) {
    opacities.push_back(column.opacity);
    opacityColors.push_back(column.opacityColor);
    contributions.push_back(column.contribution);
    contributionColors.push_back(column.contributionColor);
  }
  double opaque = 0.0, most = 0.0;
  for (const RayProfile::Sample& sample : picture.profile.samples) {
    opaque = std::max(opaque, sample.opacityPerMm);
    most = std::max(most, contributionPerMm(sample));
  }
  paintBars(painter, picture, lanes[1], opacities, opacityColors, opaque);
  paintBars(painter, picture, lanes[2], contributions, contributionColors, most);
  if (picture.crosshair)
    paintDepth(painter, picture, *picture.crosshair, QPen(crosshairColor, 1.0));
  if (picture.half)
    paintHalf(painter, picture);
  if (picture.cursor)
    paintDepth(painter, picture, *picture.cursor, QPen(picture.colors.text, 1.0, Qt::DashLine));
}

} // namespace limn
