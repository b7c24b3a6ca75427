// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/AccuracyChart.h"

#include "widgets/accuracy/PointUse.h"
#include "widgets/controls/Popups.h"
#include "widgets/theme/Theme.h"

#include <QMouseEvent>
#include <QPainter>
#include <QScreen>
#include <QToolTip>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace limn {
namespace {

constexpr double hitRadius = 12.0;
constexpr double staleOpacity = 0.45;
constexpr int leastHeight = 230; // with legible ticks on both axes
constexpr int mostHeight = 340;

} // namespace

AccuracyChart::AccuracyChart(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumHeight(leastHeight);
  setAccessibleName(tr("Chart of error against time"));
  m_picture.errorTicks = 12;
  m_picture.plainNames = true;
  dress();
}

void AccuracyChart::setReport(const AccuracyReport& report) {
  m_walked.reset();
  m_picture.current.reset();
  m_picture.hovered.reset();
  m_picture.report = report;
  setMeasure(m_picture.measure);
  setAccessibleDescription(
      tr("%1 measured points; left and right walk through them, Enter uses one.").arg(report.points.size()));
}

void AccuracyChart::setMeasure(ErrorMeasure measure) {
  m_picture.measure = measure;
  m_picture.curves = chartCurves(m_picture.report, measure);
  update();
}

void AccuracyChart::setPreferredHeight(int height) {
  m_height = std::clamp(height, leastHeight, mostHeight);
  updateGeometry();
}

void AccuracyChart::setCurrent(std::optional<std::size_t> point) {
  m_picture.current = point;
  update();
}

void AccuracyChart::setHovered(std::optional<std::size_t> point) {
  if (std::exchange(m_picture.hovered, point) != point)
    update();
}

void AccuracyChart::setStale(bool stale) {
  m_stale = stale;
  update();
}

void AccuracyChart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setOpacity(m_stale ? staleOpacity : 1.0);
  paintChart(painter, m_picture);
}

void AccuracyChart::resizeEvent(QResizeEvent*) {
  m_picture.size = size();
}

bool AccuracyChart::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip)
    return true; // told by moving
  if (event->type() == QEvent::Leave)
    setHovered(m_walked);
  return QWidget::event(event);
}

void AccuracyChart::mousePressEvent(QMouseEvent* event) {
  const std::optional<std::size_t> point = pointNear(m_picture, event->position(), hitRadius);
  if (event->button() == Qt::LeftButton && point && !m_stale)
    emit pointPicked(*point);
}

void AccuracyChart::mouseMoveEvent(QMouseEvent* event) {
  const std::optional<std::size_t> point = pointNear(m_picture, event->position(), hitRadius);
  setHovered(point);
  setCursor(point && !m_stale ? Qt::PointingHandCursor : Qt::ArrowCursor);
  if (point)
    tell(*point, event->globalPosition().toPoint());
  else
    QToolTip::hideText();
}

void AccuracyChart::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right)
    walk(event->key() == Qt::Key_Right ? 1 : -1);
  else if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && m_walked && !m_stale)
    emit pointPicked(*m_walked);
  else
    event->ignore();
}

void AccuracyChart::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange)
    dress();
}

void AccuracyChart::focusOutEvent(QFocusEvent* event) {
  m_walked.reset();
  setHovered(std::nullopt);
  QWidget::focusOutEvent(event);
}

void AccuracyChart::dress() {
  m_picture.style = isDark(palette()) ? ChartStyle::dark : ChartStyle::light;
  m_picture.textSize = QFontInfo(font()).pixelSize() * 0.85;
  update();
}

void AccuracyChart::tell(std::size_t point, const QPoint& at) {
  const MeasuredPoint& measured = m_picture.report.points[point];
  QString text = pointToolTip(measured, m_picture.report);
  if (m_stale)
    text += tr("<p>Measured for an earlier picture.</p>");
  else if (isOfTheWindow(measured.point))
    text += tr("<p>Click to use it.</p>");
  QToolTip::showText(at, text, this);
}

void AccuracyChart::walk(int direction) {
  std::vector<ChartMark> marks;
  for (const ChartCurve& curve : m_picture.curves)
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
  setHovered(m_walked);
  tell(*m_walked, mapToGlobal(placeOf(*m_walked).value_or(QPointF()).toPoint()));
}

ChartWindow::ChartWindow(QWidget* parent) : QDialog(parent), m_room(new QVBoxLayout(this)) {
  setWindowTitle(tr("Error against time"));
  setAttribute(Qt::WA_ShowWithoutActivating);
  m_room->setContentsMargins(0, 0, 0, 0);
}

void ChartWindow::openBeside(QWidget& chart, const QWidget& panel) {
  m_room->addWidget(&chart);
  chart.show();
  const QRect room = panel.screen()->availableGeometry();
  // However far the panel is scrolled.
  const QRect window(panel.window()->mapToGlobal(QPoint(0, 0)), panel.window()->size());
  const QRect column(panel.mapToGlobal(QPoint(0, 0)).x(), window.top(), panel.width(), window.height());
  setGeometry(popupPlace(sizeHint().boundedTo(room.size()), column, room));
  show();
}

} // namespace limn
