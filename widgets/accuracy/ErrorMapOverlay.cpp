// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/ErrorMapOverlay.h"

#include "accuracy/SamplePicture.h"
#include "widgets/ValueText.h"
#include "widgets/theme/Theme.h"

#include <QEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <vector>

namespace limn {
namespace {

constexpr double half = 0.5;
constexpr double mostLevels = 10.0;

constexpr double unit = 4.0; ///< of a grid
constexpr double barWidth = 3 * unit;
constexpr double mostBarHeight = 40 * unit;
constexpr double leastBarHeight = 20 * unit;
const QColor plateColor(0, 0, 0, 190); ///< light text stays legible over any picture

QString tickText(std::size_t tick) {
  const QString number = plainNumber(errorScaleTicks[tick], 1);
  return tick + 1 == errorScaleTicks.size() ? ErrorMapOverlay::tr("%1 and more").arg(number) : number;
}

QString title() {
  return ErrorMapOverlay::tr("Error, levels of 255");
}

// Wide enough for the title and for the longest label beside the bar.
// A low picture has a short bar.
QSizeF legendSize(const QFontMetricsF& metrics, double pictureHeight) {
  double beside = 0.0;
  for (std::size_t tick = 0; tick < errorScaleTicks.size(); ++tick)
    beside = std::max(beside, metrics.horizontalAdvance(tickText(tick)));
  const double width = std::max(metrics.horizontalAdvance(title()), barWidth + 2 * unit + beside);
  const double besides = 2 * metrics.height() + 5 * unit;
  const double bar = std::clamp(pictureHeight - besides - 6 * unit, leastBarHeight, mostBarHeight);
  return {width + 4 * unit, bar + besides};
}

// The map in the colours of the scale, transparent where nothing is covered.
QImage errorMapImage(const ErrorMap& map) {
  constexpr int steps = 255;
  std::vector<QRgb> colors(steps + 1);
  for (int i = 0; i <= steps; ++i)
    colors[static_cast<std::size_t>(i)] = errorScaleColor(static_cast<double>(i) / steps).rgb();
  QImage image(map.size.x, map.size.y, QImage::Format_ARGB32_Premultiplied);
  for (int y = 0; y < map.size.y; ++y) {
    auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
    for (int x = 0; x < map.size.x; ++x) {
      const float levels = map.levels[static_cast<std::size_t>(y) * static_cast<std::size_t>(map.size.x) +
                                      static_cast<std::size_t>(x)];
      row[x] =
          levels < 0.0f ? 0u : colors[static_cast<std::size_t>(std::lround(steps * errorScalePlace(levels)))];
    }
  }
  return image;
}

} // namespace

double errorScalePlace(double levels) {
  return std::clamp(std::log1p(levels / half) / std::log1p(mostLevels / half), 0.0, 1.0);
}

QColor errorScaleColor(double place) {
  // Hue in degrees from violet (300) through red (380) to yellow (460).
  const double hue = (300.0 + 160.0 * place) * std::acos(-1.0) / 180.0;
  const double chroma = 0.06 + 0.42 * place * (1.0 - place) + 0.05 * place;
  return toQColor(srgbOfOklab(0.22 + 0.74 * place, chroma * std::cos(hue), chroma * std::sin(hue)));
}

ErrorMapOverlay::ErrorMapOverlay(QWidget* view) : QWidget(view) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  setAccessibleName(tr("Map of errors over the picture"));
  setVisible(false);
  view->installEventFilter(this);
}

bool ErrorMapOverlay::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) {
    setVisible(false);
    emit outgrown();
  }
  return QWidget::eventFilter(watched, event);
}

void ErrorMapOverlay::showMap(const ErrorMap& map, const QRectF& picture) {
  m_image = errorMapImage(map);
  m_picture = picture;
  setGeometry(parentWidget()->rect());
  setVisible(true);
  raise();
  update();
}

QRectF ErrorMapOverlay::legendRect() const {
  const QSizeF size = legendSize(QFontMetricsF(font()), m_picture.height());
  // Over the picture's upper right corner beside the letter of that side, but never out of the view.
  const double besideLetter = 3 * unit + 1.5 * QFontMetricsF(font()).height();
  const double left = std::max(m_picture.right() - size.width() - besideLetter - unit, 3 * unit);
  return {QPointF(left, m_picture.top() + 3 * unit), size};
}

void ErrorMapOverlay::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  // Pixels of the map are to be seen as what they are.
  painter.drawImage(m_picture, m_image);
  painter.setRenderHint(QPainter::Antialiasing);
  const QRectF plate = legendRect();
  painter.setPen(Qt::NoPen);
  painter.setBrush(plateColor);
  painter.drawRoundedRect(plate, unit, unit);
  const QFontMetricsF metrics(font());
  const QPointF corner = plate.topLeft() + QPointF(2 * unit, unit);
  painter.setPen(Qt::white);
  painter.drawText(QRectF(corner, QSizeF(plate.width(), metrics.height())), Qt::AlignLeft, title());
  const double barHeight = plate.height() - 2 * metrics.height() - 5 * unit;
  const QRectF bar(corner.x(), corner.y() + 1.5 * metrics.height() + unit, barWidth, barHeight);
  for (double y = 0.0; y < barHeight; ++y)
    painter.fillRect(QRectF(bar.left(), bar.bottom() - y - 1.0, barWidth, 1.0),
                     errorScaleColor((y + 0.5) / barHeight));
  for (std::size_t tick = 0; tick < errorScaleTicks.size(); ++tick) {
    const double y = bar.bottom() - errorScalePlace(errorScaleTicks[tick]) * barHeight;
    painter.drawLine(QPointF(bar.right(), y), QPointF(bar.right() + unit, y));
    painter.drawText(
        QRectF(bar.right() + 2 * unit, y - metrics.height() / 2.0, plate.width(), metrics.height()),
        Qt::AlignLeft | Qt::AlignVCenter, tickText(tick));
  }
}

} // namespace limn
