// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/OverlayParts.h"

#include "scene/view/CompareLayout.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// A 4-px grid. White on this plate has a contrast of at least 5:1 even over a white picture.
constexpr double unit = 4.0;
static_assert(overlayMargin == 3 * unit);
const QColor plateColor(0, 0, 0, 160);
const QColor textColor(255, 255, 255);
const QColor quietColor(214, 218, 224);
const QColor markColor(77, 163, 255);

QFont smallFont(const QFont& font) {
  QFont small(font);
  if (font.pointSizeF() > 0.0)
    small.setPointSizeF(font.pointSizeF() * 0.85);
  return small;
}

void fillPlate(QPainter& painter, const QRectF& plate, const QColor& color) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawRoundedRect(plate, unit, unit);
}

constexpr double arrowWidth = 4 * unit;

constexpr double plateGap = 4.0; // between a text and a plate

bool inTheWay(const QRectF& plate, double top, const QSizeF& size, const std::vector<double>& columns) {
  const QRectF kept = plate.adjusted(-plateGap, -plateGap, plateGap, plateGap);
  return std::ranges::any_of(columns, [&](double column) {
    return kept.intersects(QRectF(QPointF(column - size.width() / 2.0, top), size));
  });
}

} // namespace

QFont titleFont(const QFont& font) {
  QFont bold(font);
  bold.setWeight(QFont::DemiBold);
  return bold;
}

void paintPlate(QPainter& painter, const QRectF& plate) {
  fillPlate(painter, plate, plateColor);
}

void paintOutlined(QPainter& painter, const QRectF& place, const QString& text) {
  painter.setPen(QColor(0, 0, 0, 200));
  for (const QPointF& shift : {QPointF(-1, 0), QPointF(1, 0), QPointF(0, -1), QPointF(0, 1)})
    painter.drawText(place.translated(shift), Qt::AlignCenter, text);
  painter.setPen(textColor);
  painter.drawText(place, Qt::AlignCenter, text);
}

QString fittingTitle(const QFont& font, const SideLabel& label, const QRectF& plate) {
  const double room = plate.width() - 4 * unit - (label.leadsToMenu ? arrowWidth : 0.0);
  const QFontMetricsF metrics(titleFont(font));
  // A plate that was made for it has rounding alone to spare.
  return metrics.horizontalAdvance(label.title) <= room + 0.5
             ? label.title
             : metrics.elidedText(label.title, Qt::ElideMiddle, std::max(0.0, room));
}

QString fittingDetails(const QFont& font, const QStringList& details, double room) {
  const QFontMetricsF metrics(font);
  QString line;
  for (const QString& part : details) {
    const QString longer = line.isEmpty() ? part : line + QStringLiteral(" · ") + part;
    if (metrics.horizontalAdvance(longer) > room)
      break;
    line = longer;
  }
  return line;
}

QRectF labelPlate(const QFont& font, const SideLabel& label, const QRectF& side, Qt::Alignment alignment) {
  const QFontMetricsF title(titleFont(font));
  double width = title.horizontalAdvance(label.title) + 4 * unit;
  if (label.leadsToMenu)
    width += arrowWidth;
  const double most = side.width() - 2 * overlayMargin;
  if (const QString details = fittingDetails(font, label.details, most - width - 2 * unit);
      label.detailsOpacity > 0.0 && !details.isEmpty())
    width += QFontMetricsF(font).horizontalAdvance(details) + 2 * unit;
  width = std::min(width, most);
  const double height = title.height() + 2 * unit;
  double x = side.left() + overlayMargin;
  if (alignment & Qt::AlignRight)
    x = side.right() - overlayMargin - width;
  else if (alignment & Qt::AlignHCenter)
    x = side.center().x() - width / 2;
  return {x, side.top() + overlayMargin, width, height};
}

Note noteAt(const QFont& font, const QString& text, const QPointF& corner, Qt::Alignment alignment,
            double room) {
  const QFontMetricsF metrics(smallFont(font));
  const QString fitting = metrics.elidedText(text, Qt::ElideRight, std::max(0.0, room - 3 * unit));
  const QSizeF size(metrics.horizontalAdvance(fitting) + 3 * unit, metrics.height() + unit);
  double left = corner.x();
  if (alignment & Qt::AlignRight)
    left -= size.width();
  else if (alignment & Qt::AlignHCenter)
    left -= size.width() / 2;
  return {fitting, QRectF(QPointF(left, corner.y() - size.height()), size), text};
}

QRectF scaleBarPlate(const QFont& font, const ScaleBar& bar, const QString& text, const QRectF& side) {
  const QFontMetricsF metrics(smallFont(font));
  const double width = std::max(bar.pixels, metrics.horizontalAdvance(text)) + 4 * unit;
  const double height = metrics.height() + 4 * unit;
  return {side.left() + overlayMargin, side.bottom() - overlayMargin - height, width, height};
}

void paintLabel(QPainter& painter, const SideLabel& label, const QRectF& plate) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QFont font = painter.font();
  fillPlate(painter, plate, label.hovered ? QColor(48, 56, 66, 220) : plateColor);
  QRectF text = plate.adjusted(2 * unit, 0, -2 * unit, 0);
  painter.setFont(titleFont(font));
  painter.setPen(textColor);
  const QString title = fittingTitle(font, label, plate);
  painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter, title);
  text.setLeft(text.left() + QFontMetricsF(titleFont(font)).horizontalAdvance(title));
  if (label.leadsToMenu) {
    // On whole pixels, or every label's arrow would look another.
    const QPointF tip(std::round(text.left() + 2 * unit) + 0.5, std::round(plate.center().y() + 2.0) + 0.5);
    painter.setPen(QPen(quietColor, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(QPolygonF({tip + QPointF(-unit, -unit), tip, tip + QPointF(unit, -unit)}));
    text.setLeft(text.left() + arrowWidth);
  }
  if (label.detailsOpacity > 0.0 && text.width() > 2 * unit) {
    text.setLeft(text.left() + 2 * unit);
    painter.setFont(font);
    painter.setOpacity(label.detailsOpacity);
    painter.setPen(quietColor);
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                     fittingDetails(font, label.details, text.width() + 1.0));
  }
  painter.restore();
}

void paintScaleBar(QPainter& painter, const ScaleMark& mark) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setFont(smallFont(painter.font()));
  paintPlate(painter, mark.plate);
  const double x = mark.plate.left() + 2 * unit;
  const double y = mark.plate.bottom() - 2 * unit;
  painter.setPen(QPen(textColor, 1.0));
  painter.drawPolyline(QPolygonF({QPointF(x, y - unit), QPointF(x, y), QPointF(x + mark.bar.pixels, y),
                                  QPointF(x + mark.bar.pixels, y - unit)}));
  painter.drawText(mark.plate.adjusted(2 * unit, unit, 0, 0), Qt::AlignLeft | Qt::AlignTop, mark.text);
  painter.restore();
}

QRectF differenceBarPlate(const QFont& font, const DifferenceBar& bar, const QPointF& corner) {
  const QFontMetricsF metrics(smallFont(font));
  const double words =
      metrics.horizontalAdvance(bar.leftBrighter) + metrics.horizontalAdvance(bar.rightBrighter);
  const QSizeF size(words + 10 * unit, 2 * metrics.height() + 6 * unit);
  return {corner - QPointF(size.width(), size.height()), size};
}

void paintDifferenceBar(QPainter& painter, const DifferenceBar& bar) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(smallFont(painter.font()));
  paintPlate(painter, bar.plate);
  const QRectF inside = bar.plate.adjusted(2 * unit, unit, -2 * unit, -unit);
  const double line = QFontMetricsF(painter.font()).height();
  const QRectF strip(inside.left(), inside.top() + line + unit / 2, inside.width(), 3 * unit);
  const auto colorOf = [](const glm::dvec3& color) {
    return QColor::fromRgbF(static_cast<float>(color.r), static_cast<float>(color.g),
                            static_cast<float>(color.b));
  };
  QLinearGradient colors(strip.topLeft(), strip.topRight());
  colors.setColorAt(0.0, colorOf(leftBrighterColor));
  colors.setColorAt(0.5, Qt::black);
  colors.setColorAt(1.0, colorOf(rightBrighterColor));
  painter.fillRect(strip, colors);
  painter.setPen(textColor);
  painter.drawText(inside, Qt::AlignLeft | Qt::AlignTop, bar.leftBrighter);
  painter.drawText(inside, Qt::AlignRight | Qt::AlignTop, bar.rightBrighter);
  painter.setPen(quietColor);
  painter.drawText(inside, Qt::AlignLeft | Qt::AlignBottom, bar.lowest);
  painter.drawText(inside, Qt::AlignHCenter | Qt::AlignBottom, bar.middle);
  painter.drawText(inside, Qt::AlignRight | Qt::AlignBottom, bar.highest);
  painter.restore();
}

void paintProgress(QPainter& painter, double fraction, const QRectF& view) {
  const QRectF line(view.left(), view.bottom() - 2.0, view.width(), 2.0);
  painter.fillRect(line, QColor(0, 0, 0, 120));
  painter.fillRect(QRectF(line.topLeft(), QSizeF(line.width() * fraction, line.height())), markColor);
}

void paintWipeBorder(QPainter& painter, double x, const QRectF& view, const WipeBorderLook& look) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor color = look.isHovered ? markColor : QColor(255, 255, 255, 220);
  painter.fillRect(QRectF(x - 1.5, view.top(), 3.0, view.height()), QColor(0, 0, 0, 140));
  painter.fillRect(QRectF(x - 0.5, view.top(), 1.0, view.height()), color);
  if (!look.hasKnob)
    return painter.restore();
  const QPointF centre(x, view.center().y());
  painter.setPen(QPen(color, 1.5));
  painter.setBrush(QColor(20, 22, 28, 230));
  painter.drawEllipse(centre, 3 * unit, 3 * unit);
  painter.setPen(QPen(color, 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  for (const double way : {-1.0, 1.0}) {
    const QPointF tip = centre + QPointF(way * 1.75 * unit, 0.0);
    painter.drawPolyline(
        QPolygonF({tip + QPointF(-way * unit, -unit), tip, tip + QPointF(-way * unit, unit)}));
  }
  painter.restore();
}

void paintProbe(QPainter& painter, const QPointF& point, const QString& text, const QRectF& view) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  for (const auto& [color, width] : {std::pair(QColor(0, 0, 0, 180), 3.0), std::pair(textColor, 1.0)}) {
    painter.setPen(QPen(color, width));
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
      painter.drawLine(point + 1.5 * unit * way, point + 3 * unit * way);
  }
  const QFontMetricsF metrics(painter.font());
  const QSizeF size(metrics.horizontalAdvance(text) + 4 * unit, metrics.height() + 2 * unit);
  QPointF corner = point + QPointF(4 * unit, -4 * unit - size.height());
  corner.setX(std::clamp(corner.x(), view.left(), std::max(view.left(), view.right() - size.width())));
  corner.setY(std::max(corner.y(), view.top()));
  const QRectF plate(corner, size);
  paintPlate(painter, plate);
  painter.setPen(textColor);
  painter.drawText(plate, Qt::AlignCenter, text);
  painter.restore();
}

void paintMark(QPainter& painter, const QPointF& point) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  for (const auto& [color, width] : {std::pair(QColor(0, 0, 0, 180), 3.5), std::pair(markColor, 1.5)}) {
    painter.setPen(QPen(color, width));
    painter.drawEllipse(point, 1.5 * unit, 1.5 * unit);
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
      painter.drawLine(point + 1.5 * unit * way, point + 3 * unit * way);
  }
  painter.restore();
}

void paintHiddenMark(QPainter& painter, const QPointF& point) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 90), 3.5));
  painter.drawEllipse(point, 1.5 * unit, 1.5 * unit);
  QPen dashes(markColor, 1.5, Qt::CustomDashLine, Qt::FlatCap);
  dashes.setDashPattern({1.6, 1.6}); // in widths of the line: eight dashes around
  painter.setPen(dashes);
  painter.drawEllipse(point, 1.5 * unit, 1.5 * unit);
  painter.restore();
}

void paintHalfMark(QPainter& painter, const QPointF& point) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const double reach = 1.25 * unit;
  const QPolygonF diamond{{point - QPointF(0, reach), point + QPointF(reach, 0), point + QPointF(0, reach),
                           point - QPointF(reach, 0)}};
  painter.setBrush(Qt::NoBrush);
  for (const auto& [color, width] : {std::pair(QColor(0, 0, 0, 180), 3.5), std::pair(markColor, 1.5)}) {
    painter.setPen(QPen(color, width));
    painter.drawPolygon(diamond);
  }
  const QRectF plate(point + QPointF(2 * unit, unit), QSizeF(4 * unit, 4 * unit));
  paintPlate(painter, plate);
  painter.setPen(textColor);
  painter.drawText(plate, Qt::AlignCenter, QStringLiteral("½"));
  painter.restore();
}

void paintTurnMark(QPainter& painter, const QPointF& point) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  const double reach = 2.5 * unit;
  const QRectF ring(point - QPointF(reach, reach), QSizeF(2.0 * reach, 2.0 * reach));
  const QPointF tip = point + QPointF(reach, 0.0); // where the arc ends
  for (const auto& [color, width] : {std::pair(QColor(0, 0, 0, 180), 3.5), std::pair(markColor, 1.5)}) {
    painter.setPen(QPen(color, width));
    painter.setBrush(Qt::NoBrush);
    painter.drawArc(ring, 0, 300 * 16); // sixteenths of a degree
    painter.drawPolyline(QPolygonF({tip - QPointF(unit, unit), tip, tip + QPointF(unit, -unit)}));
    painter.setBrush(color);
    painter.drawEllipse(point, 0.5 * unit, 0.5 * unit);
  }
  painter.restore();
}

void paintNote(QPainter& painter, const Note& note) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(smallFont(painter.font()));
  paintPlate(painter, note.plate);
  painter.setPen(quietColor);
  // A plate may be wider, for another text in its place.
  painter.drawText(note.plate.adjusted(1.5 * unit, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter, note.text);
  painter.restore();
}

double clearRowBelow(double top, const QSizeF& size, const std::vector<double>& columns,
                     const std::vector<QRectF>& plates) {
  // From the uppermost on: a text that has yielded to one plate may meet the next.
  std::vector<QRectF> sorted = plates;
  std::ranges::sort(sorted, [](const QRectF& a, const QRectF& b) { return a.bottom() < b.bottom(); });
  for (const QRectF& plate : sorted)
    if (inTheWay(plate, top, size, columns))
      top = plate.bottom() + plateGap;
  return top;
}

double clearRowAbove(double bottom, const QSizeF& size, const std::vector<double>& columns,
                     const std::vector<QRectF>& plates) {
  std::vector<QRectF> sorted = plates;
  std::ranges::sort(sorted, [](const QRectF& a, const QRectF& b) { return a.top() > b.top(); });
  for (const QRectF& plate : sorted)
    if (inTheWay(plate, bottom - size.height(), size, columns))
      bottom = plate.top() - plateGap;
  return bottom;
}

} // namespace limn
