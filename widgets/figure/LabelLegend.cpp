// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/figure/LabelLegend.h"

#include "planes/LabelsOnPlane.h"
#include "scene/LabelLooks.h"
#include "scene/ProjectionFacts.h"
#include "scene/regions/BodyAndLabels.h"
#include "scene/regions/LabelColor.h"
#include "widgets/figure/FigureText.h"
#include "widgets/theme/Theme.h"

#include <QFontMetricsF>
#include <QObject>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// In heights of the legend's font.
constexpr double rowOfText = 1.5;
constexpr double swatchOfText = 0.95;
constexpr double besideSwatch = 0.5;
constexpr double betweenColumns = 1.6;

// Of a slice: those that lie in it and are outlined in their colours.
std::vector<std::size_t> labelsInSlice(const FigurePanel& panel) {
  const Region& keep = panel.scene.keep;
  const LabelMap& map = keep.isCut ? *keep.uncut : *keep.labels;
  constexpr int side = 256; // what is smaller in it than a pixel of that is not looked for
  const PlanePlaces found = placesOn(map, panel.scene.volume->grid(), planeFrameOf(panel, {side, side}).grid);
  std::vector<bool> isThere(map.labels().size());
  for (const std::uint32_t place : found.places)
    if (place != PlanePlaces::nowhere)
      isThere[place] = true;
  std::vector<std::size_t> places;
  for (std::size_t place = 0; place < listedLabels(keep); ++place)
    if (isThere[place] && map.labels()[place].value != 0 && keep.weights[place] > 0.0)
      places.push_back(place);
  return places;
}

// Those that a picture shows by curves of their own; of a slice those that it outlines.
std::vector<std::size_t> labelsShown(const FigurePanel& panel) {
  const Region& keep = panel.scene.keep;
  std::vector<std::size_t> places;
  if (keep.kind != Region::Kind::labels || !keep.labels)
    return places;
  if (panel.plane && panel.planes.outlinesRegion)
    return labelsInSlice(panel);
  if (panel.plane ? !panel.planes.isTinted : !integrates(panel.scene.projection))
    return places;
  for (std::size_t place = 0; place < ownLabels(keep); ++place) {
    const VoxelBox& box = keep.labels->boxAround(place);
    if (lookOfLabel(keep, place) > 0 && keep.weights[place] > 0.0 && box.lower != box.upper)
      places.push_back(place);
  }
  return places;
}

// Measured where rounding to whole pixels plays no part, so that a small figure is laid out as a large one.
double widthOfText(const QString& text, const FigureLayout& layout) {
  FigureLayout large = layout;
  large.textPixels = 100.0;
  return QFontMetricsF(figureFont(large, noteScale)).horizontalAdvance(text) / 100.0;
}

} // namespace

PanelLabels panelLabels(const FigurePanel& panel) {
  const Region& keep = panel.scene.keep;
  const bool hasOutline = panel.plane && !panel.planes.isTinted;
  const std::vector<std::size_t> places = labelsShown(panel);
  PanelLabels labels;
  for (const std::size_t place : places) {
    const std::size_t look = hasOutline ? 0 : lookOfLabel(keep, place);
    if (labels.rows.size() == mostLabelRows) {
      labels.undrawn += look > 0 ? 1 : 0;
      continue;
    }
    const Label& label = keep.labels->labels()[place];
    const QColor color = toQColor(shownColor(*panel.scene.volume, keep, place));
    labels.rows.push_back({color, QString::fromStdString(label.name)});
    if (look > 0)
      labels.curves.push_back({color, keep.looks[look - 1]});
  }
  if (places.size() > labels.rows.size())
    labels.rows.push_back({std::nullopt, QObject::tr("and %1 more").arg(places.size() - labels.rows.size())});
  return labels;
}

FigureLabels figureLabels(const Figure& figure) {
  const bool areNamed = figure.settings.shows(FigureMark::labels);
  FigureLabels all(figure.panels.size());
  if (areNamed || figure.settings.shows(FigureMark::curve))
    std::ranges::transform(figure.panels, all.begin(), panelLabels);
  if (!areNamed)
    for (PanelLabels& labels : all)
      labels = {{}, {}, labels.undrawn + labels.curves.size()};
  return all;
}

LabelColumns labelColumns(const std::vector<LabelRow>& rows, double width, double textPixels) {
  LabelColumns result;
  if (rows.empty())
    return result;
  const double text = noteScale * textPixels;
  FigureLayout layout;
  layout.textPixels = textPixels;
  double widest = 0.0;
  for (const LabelRow& row : rows)
    widest = std::max(widest, widthOfText(row.text, layout) * textPixels);
  const double wanted = widest + (swatchOfText + besideSwatch + betweenColumns) * text;
  const auto count = static_cast<int>(rows.size());
  result.columns = std::clamp(static_cast<int>(width / wanted), 1, count);
  const int high = (count + result.columns - 1) / result.columns;
  result.columns = (count + high - 1) / high;
  result.columnWidth = std::min(wanted, width / result.columns);
  result.rowHeight = std::round(rowOfText * text);
  result.height = high * result.rowHeight;
  return result;
}

void paintLabelRows(QPainter& painter, const QRectF& place, const std::vector<LabelRow>& rows,
                    const FigureLayout& layout, const QColor& text, const QColor& line) {
  painter.save();
  const QFont font = figureFont(layout, noteScale);
  const QFontMetricsF metrics(font);
  const LabelColumns columns = labelColumns(rows, place.width(), layout.textPixels);
  const int high = std::max(1, static_cast<int>(std::lround(columns.height / columns.rowHeight)));
  const double size = swatchOfText * font.pixelSize();
  painter.setFont(font);
  for (int n = 0; n < static_cast<int>(rows.size()); ++n) {
    const LabelRow& row = rows[static_cast<std::size_t>(n)];
    const QRectF cell(place.left() + (n / high) * columns.columnWidth,
                      place.top() + (n % high) * columns.rowHeight, columns.columnWidth, columns.rowHeight);
    if (row.color) {
      painter.setPen(QPen(line, std::max(1.0, font.pixelSize() / 14.0)));
      painter.setBrush(*row.color);
      painter.drawRect(QRectF(cell.left(), cell.center().y() - size / 2.0, size, size));
    }
    const QRectF words =
        cell.adjusted(row.color ? size + besideSwatch * font.pixelSize() : 0.0, 0.0, 0.0, 0.0);
    painter.setPen(text);
    painter.drawText(words, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextSingleLine,
                     metrics.elidedText(row.text, Qt::ElideRight, words.width()));
  }
  painter.restore();
}

} // namespace limn
