// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/chart/AccuracyChart.h"

#include "widgets/ValueText.h"
#include "widgets/accuracy/chart/ChartNotes.h"
#include "widgets/accuracy/points/PointText.h"

#include <QCategoryAxis>
#include <QGraphicsLayout>
#include <QGuiApplication>
#include <QLegendMarker>
#include <QLineSeries>
#include <QScatterSeries>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double ringSize = 1.4; ///< of a mark, in text sizes
constexpr double markSize = 0.85;
// A clock may tell 0 ms; a logarithm cannot.
constexpr double leastShownMs = 0.001;

QString ringsName() {
  return AccuracyChart::tr("best trade-offs");
}

QCategoryAxis* categoryAxis(const LogAxis& axis, const QString& title) {
  auto* shown = new QCategoryAxis;
  shown->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
  shown->setRange(std::log10(axis.lowest), std::log10(axis.highest));
  // Beyond the axis, where its tick is not seen.
  shown->setStartValue(std::log10(axis.lowest) - 1.0);
  for (const double tick : axis.ticks)
    shown->append(plainNumber(tick, 4), std::log10(tick));
  shown->setTitleText(title);
  return shown;
}

} // namespace

AccuracyChart::AccuracyChart(QGraphicsItem* parent) : QChart(parent), m_notes(new ChartNotes(*this)) {
  legend()->setMarkerShape(QLegend::MarkerShapeFromSeries);
  setBackgroundRoundness(0.0);
  setLegendAtRight(false);
  dress();
}

void AccuracyChart::setLegendAtRight(bool atRight) {
  m_legendAtRight = atRight;
  legend()->setAlignment(Qt::AlignRight);
}

void AccuracyChart::setMostTicks(int timeTicks, int errorTicks) {
  m_timeTicks = timeTicks;
  m_errorTicks = errorTicks;
}

void AccuracyChart::setReport(const AccuracyReport& report) {
  m_report = report;
  m_curves = chartCurves(report, m_measure);
  removeAllSeries();
  for (QAbstractAxis* axis : axes()) {
    removeAxis(axis);
    delete axis;
  }
  legend()->setVisible(m_legendAtRight && !m_curves.empty());
  if (!m_curves.empty()) {
    addAxes();
    const std::vector<QPointF> best = bestTradeOffs();
    addTradeOffLine(best);
    for (std::size_t i = 0; i < m_curves.size(); ++i)
      addCurve(m_curves[i], curveLook(m_style, static_cast<int>(i)));
    addTradeOffRings(best);
  }
  dress();
  arrange();
  m_notes->update();
}

void AccuracyChart::setCurrent(std::optional<std::size_t> point) {
  m_current = point;
  m_notes->update();
}

void AccuracyChart::setHovered(std::optional<std::size_t> point) {
  if (point == m_hovered)
    return;
  m_hovered = point;
  m_notes->update();
}

void AccuracyChart::addAxes() {
  double leastMs = 1e9, mostMs = 0.0, leastError = 1.0, mostError = 1.0;
  for (const ChartCurve& curve : m_curves)
    for (const ChartMark& mark : curve.marks) {
      leastMs = std::min(leastMs, mark.leastMs);
      mostMs = std::max(mostMs, mark.mostMs);
      leastError = std::min(leastError, mark.error);
      mostError = std::max(mostError, mark.error);
    }
  leastMs = std::max(leastMs, leastShownMs);
  m_timeAxis = logAxisAround(leastMs, std::max(mostMs, leastMs), m_timeTicks);
  m_errorAxis = logAxisAround(leastError, mostError, m_errorTicks);
  addAxis(categoryAxis(m_timeAxis, tr("Time per picture, ms")), Qt::AlignBottom);
  // Where it is cut, the list below still says of which error.
  addAxis(categoryAxis(m_errorAxis, m_measure == ErrorMeasure::mean
                                        ? tr("Error, levels of 255 (mean)")
                                        : tr("Error, levels of 255 (99.9th percentile)")),
          Qt::AlignLeft);
}

// From fast to slow. What is best by the 99.9th percentile need not be so by the mean.
std::vector<QPointF> AccuracyChart::bestTradeOffs() const {
  std::vector<QPointF> best;
  if (m_measure == ErrorMeasure::mean)
    return best;
  for (const ChartCurve& curve : m_curves)
    for (const ChartMark& mark : curve.marks)
      if (mark.isPareto)
        best.push_back(placeOf(mark));
  std::sort(best.begin(), best.end(), [](const QPointF& a, const QPointF& b) { return a.x() < b.x(); });
  return best;
}

void AccuracyChart::addTradeOffLine(const std::vector<QPointF>& best) {
  auto* line = new QLineSeries;
  line->setPen(
      QPen(chartColors(m_style).trade, 0.9 * m_textSize, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  for (const QPointF& place : best)
    line->append(place);
  attach(line, false);
}

void AccuracyChart::addTradeOffRings(const std::vector<QPointF>& best) {
  auto* rings = new QScatterSeries;
  rings->setName(ringsName());
  rings->setMarkerSize(ringSize * m_textSize);
  rings->setColor(Qt::transparent);
  rings->setPen(QPen(chartColors(m_style).secondaryText, 0.06 * m_textSize));
  for (const QPointF& place : best)
    rings->append(place);
  attach(rings, !best.empty());
}

void AccuracyChart::addCurve(const ChartCurve& curve, const CurveLook& look) {
  auto* line = new QLineSeries;
  line->setPen(QPen(look.color, 0.13 * m_textSize, look.isDashed ? Qt::DashLine : Qt::SolidLine, Qt::RoundCap,
                    Qt::RoundJoin));
  for (const ChartMark& mark : curve.marks)
    line->append(placeOf(mark));
  attach(line, false);
  QScatterSeries* hollow = addMarks(look, false);
  QScatterSeries* filled = addMarks(look, true);
  const bool allHollow = std::all_of(curve.marks.begin(), curve.marks.end(),
                                     [](const ChartMark& mark) { return mark.isBelowFloor; });
  for (const ChartMark& mark : curve.marks)
    (mark.isBelowFloor ? hollow : filled)->append(placeOf(mark));
  (allHollow ? hollow : filled)->setName(nameOf(curve));
  attach(hollow, allHollow);
  attach(filled, !allHollow);
}

QScatterSeries* AccuracyChart::addMarks(const CurveLook& look, bool filled) {
  auto* marks = new QScatterSeries;
  marks->setMarkerShape(look.shape);
  marks->setMarkerSize(markSize * m_textSize);
  marks->setColor(filled ? look.color : chartColors(m_style).background);
  marks->setBorderColor(look.color);
  return marks;
}

void AccuracyChart::attach(QXYSeries* series, bool isInLegend) {
  addSeries(series);
  for (QAbstractAxis* axis : axes())
    series->attachAxis(axis);
  for (QLegendMarker* marker : legend()->markers(series))
    marker->setVisible(isInLegend);
}

void AccuracyChart::dress() {
  const ChartColors colors = chartColors(m_style);
  setBackgroundBrush(colors.background);
  setBackgroundPen(Qt::NoPen);
  layout()->setContentsMargins(0, 0, 0, 0);
  setTitleFont(textFont(1.05));
  setTitleBrush(colors.text);
  legend()->setFont(textFont(0.95));
  legend()->setLabelColor(colors.text);
  for (QAbstractAxis* axis : axes()) {
    axis->setLabelsFont(textFont(0.92));
    axis->setLabelsColor(colors.secondaryText);
    axis->setTitleFont(textFont());
    axis->setTitleBrush(colors.text);
    axis->setGridLineColor(colors.grid);
    axis->setLinePen(QPen(colors.border, 1.0));
    axis->setTruncateLabels(false);
  }
}

void AccuracyChart::resizeEvent(QGraphicsSceneResizeEvent* event) {
  QChart::resizeEvent(event);
  arrange();
}

void AccuracyChart::arrange() {
  const double margin = 0.6 * m_textSize;
  setMargins(QMarginsF(margin, margin, 1.2 * margin, margin + legendRect().height()).toMargins());
}

// Of the legend below the plot; empty where it stands at the right.
QRectF AccuracyChart::legendRect() const {
  if (m_legendAtRight)
    return {};
  const double margin = m_textSize;
  const double width = size().width() - 2.0 * margin;
  const double height = legendLayout(legendEntries(), legend()->font(), width).height;
  return {margin, size().height() - height - 0.3 * margin, width, height};
}

std::vector<LegendEntry> AccuracyChart::legendEntries() const {
  std::vector<LegendEntry> entries;
  for (std::size_t i = 0; i < m_curves.size(); ++i) {
    const CurveLook look = curveLook(m_style, static_cast<int>(i));
    entries.push_back({nameOf(m_curves[i]), look.color, look.shape, markSize * m_textSize, true});
  }
  if (!bestTradeOffs().empty())
    entries.push_back({ringsName(), chartColors(m_style).secondaryText, QScatterSeries::MarkerShapeCircle,
                       ringSize * m_textSize, false});
  return entries;
}

// All points of a curve belong to one family.
QString AccuracyChart::nameOf(const ChartCurve& curve) const {
  const OperatingPoint& point = m_report.points[curve.marks.front().index].point;
  return m_plainNames ? familyText(point) : QString::fromStdString(curve.family);
}

QFont AccuracyChart::textFont(double scale) const {
  QFont font = QGuiApplication::font();
  font.setPixelSize(std::max(8, qRound(scale * m_textSize)));
  return font;
}

QPointF AccuracyChart::placeOf(const ChartMark& mark) const {
  return {std::log10(std::max(mark.ms, leastShownMs)), std::log10(mark.error)};
}

QPointF AccuracyChart::positionAt(double ms, double levels) const {
  const auto fraction = [](const LogAxis& axis, double value) {
    return std::log10(value / axis.lowest) / std::log10(axis.highest / axis.lowest);
  };
  const QRectF plot = plotArea();
  return {plot.left() + fraction(m_timeAxis, std::max(ms, leastShownMs)) * plot.width(),
          plot.bottom() - fraction(m_errorAxis, levels) * plot.height()};
}

std::optional<QPointF> AccuracyChart::positionOf(std::size_t point) const {
  for (const ChartCurve& curve : m_curves)
    for (const ChartMark& mark : curve.marks)
      if (mark.index == point)
        return positionAt(mark.ms, mark.error);
  return std::nullopt;
}

std::optional<std::size_t> AccuracyChart::pointNear(const QPointF& position, double radius) const {
  std::optional<std::size_t> nearest;
  for (const ChartCurve& curve : m_curves)
    for (const ChartMark& mark : curve.marks) {
      const QPointF away = positionAt(mark.ms, mark.error) - position;
      const double distance = std::hypot(away.x(), away.y());
      if (distance > radius)
        continue;
      radius = distance;
      nearest = mark.index;
    }
  return nearest;
}

} // namespace limn
