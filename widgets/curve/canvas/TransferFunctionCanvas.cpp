// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/canvas/TransferFunctionCanvas.h"

#include "widgets/ValueText.h"
#include "widgets/curve/plot/HistogramPicture.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace limn {

TransferFunctionCanvas::TransferFunctionCanvas(CurveSubject subject, QWidget* parent)
    : QWidget(parent), m_subject(subject) {
  setMouseTracking(true);
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(subject == CurveSubject::value ? tr("Transfer function curve")
                                                   : tr("Curve of opacity over the gradient"));
  setAccessibleDescription(
      tr("Tab walks the points, arrows move them, Enter edits numbers, Delete removes, Ctrl+A selects all."));
}

void TransferFunctionCanvas::setTransferFunction(const TransferFunction& function) {
  if (function == m_function)
    return;
  // What comes from elsewhere (undo, a preset) ends a drag that worked on something else.
  m_drag = {};
  m_hovered = {};
  if (function.points.size() != m_function.points.size())
    m_selected.clear();
  m_function = function;
  if (m_histogram.counts.empty())
    resetView();
  update();
}

void TransferFunctionCanvas::setHistogram(const Histogram& histogram) {
  const bool sameRange =
      histogram.range == m_histogram.range && m_histogram.counts.empty() == histogram.counts.empty();
  m_histogram = histogram;
  m_histogramPicture = {};
  if (!sameRange)
    resetView();
  update();
}

void TransferFunctionCanvas::setUnit(const QString& unit) {
  m_unit = unit;
  update();
}

void TransferFunctionCanvas::setMarkedValue(std::optional<double> value) {
  m_markedValue = value;
  update();
}

void TransferFunctionCanvas::setPinnedValue(std::optional<double> value) {
  m_pinnedValue = value;
  update();
}

void TransferFunctionCanvas::setFineLowOpacities(bool fine) {
  m_fineLowOpacities = fine;
  update();
}

void TransferFunctionCanvas::setHint(const QString& hint) {
  m_hint = hint;
  update();
}

PlotTransform TransferFunctionCanvas::transform() const {
  const double plotBottom = ticksBelow + (hasColors(m_subject) ? stripBelow : 0.0);
  const QRectF plot(plotLeft, plotTop, std::max(20.0, width() - plotLeft - plotRight),
                    std::max(20.0, height() - plotTop - plotBottom));
  return {plot, m_visible, m_fineLowOpacities};
}

int TransferFunctionCanvas::shownDecimals() const {
  return decimalsFor(valuePerPixel(transform()));
}

double TransferFunctionCanvas::valueUnit() const {
  if (m_unit == QLatin1String("HU"))
    return 1.0;
  const ValueRange full = fullRange();
  return std::pow(10.0, std::floor(std::log10((full.highest - full.lowest) / 500.0)));
}

ValueRange TransferFunctionCanvas::fullRange() const {
  ValueRange full = m_histogram.counts.empty() ? ValueRange{1e300, -1e300} : m_histogram.range;
  for (const ControlPoint& point : m_function.points) {
    full.lowest = std::min(full.lowest, point.value);
    full.highest = std::max(full.highest, point.value);
  }
  if (full.lowest > full.highest)
    return {0.0, 1.0};
  const double width = full.highest - full.lowest;
  // A constant volume still needs an axis.
  const double margin = width > 0.0 ? 0.03 * width : std::max(1.0, std::abs(full.lowest) * 0.1);
  return {full.lowest - margin, full.highest + margin};
}

void TransferFunctionCanvas::resetView() {
  showView(fullRange());
}

void TransferFunctionCanvas::showView(const ValueRange& visible) {
  m_visible = visible;
  update();
}

bool TransferFunctionCanvas::isSelected(std::size_t index) const {
  return std::find(m_selected.begin(), m_selected.end(), index) != m_selected.end();
}

QString TransferFunctionCanvas::textOf(double value) const {
  return valueText(value, m_unit, shownDecimals());
}

void TransferFunctionCanvas::selectPoints(const PointIndices& indices) {
  if (indices == m_selected)
    return;
  m_selected = indices;
  update();
  emit selectionChanged();
}

void TransferFunctionCanvas::selectAll() {
  PointIndices all(m_function.points.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  selectPoints(all);
}

void TransferFunctionCanvas::deleteSelected() {
  const PointIndices deleted = m_selected;
  const TransferFunction remaining = withPointsDeleted(m_function, deleted);
  if (remaining == m_function)
    return;
  const QString text = deleted.size() > 1
                           ? tr("delete %1 points").arg(deleted.size())
                           : tr("delete point at %1").arg(textOf(m_function.points[deleted[0]].value));
  // The neighbour is next in hand, so that Delete can be pressed again.
  const std::size_t next = std::min(deleted.front(), remaining.points.size() - 1);
  edit(remaining, {nextGestureId(), text});
  selectPoints({next});
}

void TransferFunctionCanvas::edit(const TransferFunction& wanted, const Gesture& gesture) {
  const TransferFunction function = limitedTo(m_subject, wanted);
  if (function == m_function)
    return;
  const bool sameCount = function.points.size() == m_function.points.size();
  m_function = function;
  if (!sameCount) {
    m_hovered = {};
    selectPoints({});
  }
  update();
  emit transferFunctionEdited(function, gesture);
}

CanvasPicture TransferFunctionCanvas::picture() {
  const PlotTransform plot = transform();
  const ThemeColors colors = themeColors(palette());
  const HistogramCache key{plot, colors.histogram, devicePixelRatioF()};
  if (!m_histogram.counts.empty() && (m_histogramPicture.isNull() || key != m_histogramKey)) {
    m_histogramKey = key;
    m_histogramPicture = histogramPicture(m_histogram, plot, colors.histogram, devicePixelRatioF());
  }
  CanvasPicture picture;
  picture.subject = m_subject;
  picture.function = m_function;
  picture.transform = plot;
  picture.colors = colors;
  picture.unit = m_unit;
  picture.decimals = shownDecimals();
  picture.histogram = m_histogram.counts.empty() ? QPixmap() : m_histogramPicture;
  picture.hint =
      m_hint.isEmpty() && m_histogram.counts.empty() ? tr("Open a volume to see its histogram") : m_hint;
  picture.selected = m_selected;
  picture.hoveredValue = m_hoveredValue;
  picture.markedValue = m_markedValue;
  picture.pinnedValue = m_pinnedValue;
  picture.hoveredPart = m_hovered.part;
  picture.focused = hasFocus();
  if (m_hovered.part == CurveHit::Part::point)
    picture.hoveredPoint = picture.readOut = m_hovered.index;
  if (m_drag.kind == CurveDrag::Kind::points)
    picture.readOut = m_drag.grabbed;
  if (m_drag.kind == CurveDrag::Kind::band && m_drag.started)
    picture.band = QRectF(m_drag.press, m_drag.last).normalized() & plot.plot.adjusted(-6.0, -6.0, 6.0, 6.0);
  return picture;
}

void TransferFunctionCanvas::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  QFont small = font();
  small.setPointSizeF(small.pointSizeF() * 0.92);
  painter.setFont(small);
  const CanvasPicture shown = picture();
  paintAxes(painter, shown);
  paintCurve(painter, shown);
}

} // namespace limn
