// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/chart/AccuracyChartView.h"

#include "widgets/Theme.h"
#include "widgets/accuracy/chart/AccuracyChart.h"
#include "widgets/accuracy/points/PointText.h"
#include "widgets/accuracy/points/PointUse.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>

namespace limn {
namespace {

constexpr double hitRadius = 12.0;
constexpr double staleOpacity = 0.45;
constexpr int leastHeight = 230; // with legible ticks on both axes
constexpr int mostHeight = 340;

} // namespace

// A chart set later would leave the view's own first one to nobody.
AccuracyChartView::AccuracyChartView(QWidget* parent)
    : QChartView(new AccuracyChart, parent), m_chart(static_cast<AccuracyChart*>(chart())) {
  setRenderHint(QPainter::Antialiasing);
  setFrameShape(QFrame::NoFrame);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setMinimumHeight(leastHeight);
  setAccessibleName(tr("Chart of error against time"));
  viewport()->setAccessibleName(accessibleName());
  m_chart->setMostTicks(6, 12);
  m_chart->setPlainNames(true);
  dress();
}

void AccuracyChartView::setReport(const AccuracyReport& report) {
  m_walked.reset();
  m_chart->setReport(report);
  m_chart->setCurrent(std::nullopt);
  setAccessibleDescription(
      tr("%1 measured points; left and right walk through them, Enter uses one.").arg(report.points.size()));
}

void AccuracyChartView::setMeasure(ErrorMeasure measure) {
  m_chart->setMeasure(measure);
  m_chart->setReport(m_chart->report());
}

void AccuracyChartView::setPreferredHeight(int height) {
  m_height = std::clamp(height, leastHeight, mostHeight);
  updateGeometry();
}

void AccuracyChartView::setCurrent(std::optional<std::size_t> point) {
  m_chart->setCurrent(point);
}

void AccuracyChartView::setStale(bool stale) {
  m_stale = stale;
  m_chart->setOpacity(stale ? staleOpacity : 1.0);
}

std::optional<QPointF> AccuracyChartView::positionOf(std::size_t point) const {
  const std::optional<QPointF> place = m_chart->positionOf(point);
  return place ? std::optional<QPointF>(mapFromScene(m_chart->mapToScene(*place))) : std::nullopt;
}

bool AccuracyChartView::viewportEvent(QEvent* event) {
  if (event->type() == QEvent::ToolTip)
    return true; // told by moving
  if (event->type() == QEvent::Leave)
    m_chart->setHovered(m_walked);
  return QChartView::viewportEvent(event);
}

void AccuracyChartView::mousePressEvent(QMouseEvent* event) {
  const QPointF place = m_chart->mapFromScene(mapToScene(event->position().toPoint()));
  const std::optional<std::size_t> point = m_chart->pointNear(place, hitRadius);
  if (event->button() == Qt::LeftButton && point && !m_stale)
    emit pointPicked(*point);
}

void AccuracyChartView::mouseMoveEvent(QMouseEvent* event) {
  const QPointF place = m_chart->mapFromScene(mapToScene(event->position().toPoint()));
  const std::optional<std::size_t> point = m_chart->pointNear(place, hitRadius);
  m_chart->setHovered(point);
  viewport()->setCursor(point && !m_stale ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (point)
    tell(*point, event->globalPosition().toPoint());
  else
    QToolTip::hideText();
}

void AccuracyChartView::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)
    walk(event->key() == Qt::Key_Right ? 1 : -1);
  else if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && m_walked && !m_stale)
    emit pointPicked(*m_walked);
  else
    event->ignore();
}

// The panel around it scrolls.
void AccuracyChartView::wheelEvent(QWheelEvent* event) {
  event->ignore();
}

void AccuracyChartView::changeEvent(QEvent* event) {
  QChartView::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
    dress();
}

void AccuracyChartView::focusOutEvent(QFocusEvent* event) {
  m_walked.reset();
  m_chart->setHovered(std::nullopt);
  QChartView::focusOutEvent(event);
}

void AccuracyChartView::dress() {
  m_chart->setStyle(isDark(palette()) ? ChartStyle::dark : ChartStyle::light);
  m_chart->setTextSize(QFontInfo(font()).pixelSize() * 0.85);
  m_chart->setReport(m_chart->report());
  setBackgroundBrush(palette().window());
}

void AccuracyChartView::tell(std::size_t point, const QPoint& at) {
  const MeasuredPoint& measured = m_chart->report().points[point];
  QString text = pointToolTip(measured, m_chart->report());
  if (m_stale)
    text += tr("<p>Measured for an earlier picture.</p>");
  else if (isOfTheWindow(measured.point))
    text += tr("<p>Click to use it.</p>");
  QToolTip::showText(at, text, this);
}

void AccuracyChartView::walk(int direction) {
  std::vector<ChartMark> marks;
  for (const ChartCurve& curve : m_chart->curves())
    marks.insert(marks.end(), curve.marks.begin(), curve.marks.end());
  if (marks.empty())
    return;
  std::sort(marks.begin(), marks.end(), [](const ChartMark& a, const ChartMark& b) { return a.ms < b.ms; });
  const auto here = std::find_if(marks.begin(), marks.end(),
                                 [this](const ChartMark& mark) { return mark.index == m_walked; });
  const std::ptrdiff_t last = static_cast<std::ptrdiff_t>(marks.size()) - 1;
  const std::ptrdiff_t next = here == marks.end()
                                  ? (direction > 0 ? 0 : last)
                                  : std::clamp<std::ptrdiff_t>(here - marks.begin() + direction, 0, last);
  m_walked = marks[static_cast<std::size_t>(next)].index;
  m_chart->setHovered(m_walked);
  const QPointF place = positionOf(*m_walked).value_or(QPointF());
  tell(*m_walked, viewport()->mapToGlobal(place.toPoint()));
}

} // namespace limn
