// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/StopSlider.h"

#include "widgets/controls/FoldingSection.h"
#include "widgets/theme/Theme.h"

#include <QEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double handleRadius = 7.0;
constexpr double stopRadius = 3.0;
constexpr double trackHeight = 20.0;
constexpr double rowGap = 2.0;

QFont smallFont(const QFont& font) {
  QFont smaller = font;
  smaller.setPointSizeF(0.88 * font.pointSizeF());
  return smaller;
}

} // namespace

StopSlider::StopSlider(QWidget* parent) : QAbstractSlider(parent) {
  setOrientation(Qt::Horizontal);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setPageStep(1);
  connect(this, &QAbstractSlider::valueChanged, this, [this](int stop) {
    m_place = stop;
    update();
    emit stopPicked(stop);
  });
}

void StopSlider::setStops(const std::vector<SliderStop>& stops, const QStringList& captions) {
  if (stops == m_stops && captions == m_captions)
    return;
  m_stops = stops;
  m_captions = captions;
  const QSignalBlocker quiet(this);
  setRange(0, static_cast<int>(stops.size()) - 1);
  updateGeometry();
  update();
}

void StopSlider::setPlace(double place) {
  m_place = std::clamp(place, 0.0, static_cast<double>(maximum()));
  const QSignalBlocker quiet(this);
  setValue(static_cast<int>(std::lround(m_place)));
  update();
}

QSize StopSlider::sizeHint() const {
  const auto rows = static_cast<double>(m_captions.size());
  return {240, static_cast<int>(std::ceil(trackHeight + rows * (textHeight() + rowGap)))};
}

QSize StopSlider::minimumSizeHint() const {
  return {180, sizeHint().height()};
}

void StopSlider::paintEvent(QPaintEvent*) {
  const ThemeColors colors = themeColors(palette());
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor accent = isEnabled() ? colors.accent : colors.disabledText;
  painter.setPen(QPen(colors.outline, 3.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(centreAt(0.0), centreAt(maximum()));
  painter.setPen(QPen(accent, 3.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(centreAt(0.0), centreAt(m_place));
  painter.setPen(Qt::NoPen);
  for (int stop = 0; stop <= maximum(); ++stop) {
    painter.setBrush(stop <= m_place ? accent : colors.outline);
    painter.drawEllipse(centreAt(stop), stopRadius, stopRadius);
  }
  painter.setPen(QPen(hasFocus() ? colors.text : accent, hasFocus() ? 2.0 : 1.5));
  painter.setBrush(std::lround(m_place) == m_place ? accent : colors.base);
  painter.drawEllipse(centreAt(m_place), handleRadius, handleRadius);
  paintTexts(painter);
}

void StopSlider::paintTexts(QPainter& painter) const {
  const ThemeColors colors = themeColors(palette());
  painter.setFont(smallFont(font()));
  const double between = maximum() > 0 ? centreAt(1.0).x() - centreAt(0.0).x() : width();
  const auto cell = [&](double x, int row) {
    return QRectF(x - between / 2.0, trackHeight + row * (textHeight() + rowGap), between, textHeight());
  };
  for (int stop = 0; stop <= maximum(); ++stop) {
    const SliderStop& shown = m_stops[static_cast<std::size_t>(stop)];
    const bool isChosen = stop == m_place;
    painter.setPen(isEnabled() ? colors.text : colors.disabledText);
    painter.drawText(cell(centreAt(stop).x(), 0), Qt::AlignCenter, shown.name);
    painter.setPen(!isEnabled() || shown.isDim ? colors.disabledText
                   : isChosen                  ? colors.text
                                               : colors.secondaryText);
    for (int row = 0; row < shown.figures.size(); ++row)
      painter.drawText(cell(centreAt(stop).x(), row + 1), Qt::AlignCenter, shown.figures[row]);
  }
  painter.setPen(isEnabled() ? colors.secondaryText : colors.disabledText);
  for (int row = 0; row < m_captions.size(); ++row)
    painter.drawText(QRectF(0.0, cell(0.0, row).top(), captionWidth(), textHeight()),
                     Qt::AlignLeft | Qt::AlignVCenter, m_captions[row]);
}

void StopSlider::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton)
    pickAt(event->position().x());
}

void StopSlider::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton)
    pickAt(event->position().x());
}

// Scrolling a panel must change nothing on the way.
void StopSlider::wheelEvent(QWheelEvent* event) {
  if (takesWheel(*this))
    QAbstractSlider::wheelEvent(event);
  else
    event->ignore();
}

void StopSlider::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange)
    updateGeometry();
  QAbstractSlider::changeEvent(event);
}

QPointF StopSlider::centreAt(double place) const {
  // Names and figures stand centred below their stops and need half of their room beyond the outer ones.
  const double left = captionWidth() + 22.0;
  const double right = width() - 16.0;
  const double fraction = maximum() > 0 ? place / maximum() : 0.0;
  return {left + fraction * (right - left), trackHeight / 2.0};
}

double StopSlider::captionWidth() const {
  const QFontMetricsF metrics(smallFont(font()));
  double widest = 0.0;
  for (const QString& caption : m_captions)
    widest = std::max(widest, metrics.horizontalAdvance(caption));
  return widest;
}

double StopSlider::textHeight() const {
  return QFontMetricsF(smallFont(font())).height();
}

void StopSlider::pickAt(double x) {
  const double first = centreAt(0.0).x();
  const double last = centreAt(maximum()).x();
  const double place = std::clamp((x - first) / (last - first), 0.0, 1.0) * maximum();
  const int stop = static_cast<int>(std::lround(place));
  if (stop == m_place)
    return;
  // From between two stops to the nearest one the value stays and has to be reported here.
  const bool isReported = stop != value();
  setValue(stop);
  if (isReported)
    return;
  m_place = stop;
  update();
  emit stopPicked(stop);
}

} // namespace limn
