// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/curve/picture/CanvasPicture.h"

#include "widgets/ValueText.h"
#include "widgets/plot/Axes.h"
#include "widgets/theme/Theme.h"

#include <QObject>
#include <QPaintDevice>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Margins around the plot, pixels: room for the bar above, opacity labels left, the colour strip (where the
// curve has colours) and ticks below.
constexpr double plotLeft = 52.0;
constexpr double plotTop = 20.0;
constexpr double plotRight = 12.0;
constexpr double ticksBelow = 25.0;
constexpr double stripBelow = 15.0;

constexpr double stripHeight = 10.0;
constexpr double stripGap = stripBelow - stripHeight;
constexpr double pixelsPerTick = 90.0;
constexpr double pixelsPerOpacityTick = 24.0;

std::vector<AxisTick> opacityTicks(const PlotTransform& transform) {
  std::vector<double> opacities{0.0, 0.25, 0.5, 0.75, 1.0};
  if (transform.upScale == AxisScale::cubeRoot)
    opacities = {0.0, 0.001, 0.01, 0.05, 0.2, 0.5, 1.0};
  else if (transform.plot.height() < 4.0 * pixelsPerOpacityTick)
    opacities = {0.0, 0.5, 1.0};
  std::vector<AxisTick> ticks;
  for (const double opacity : opacities)
    ticks.push_back({opacity, plainNumber(opacity, 3)});
  return ticks;
}

QString axisText(const CanvasPicture& picture) {
  if (!picture.unit.isEmpty())
    return picture.unit;
  return picture.subject == CurveSubject::value ? QObject::tr("value") : QObject::tr("gradient");
}

void paintColorStrip(QPainter& painter, const CanvasPicture& picture) {
  const QRectF& plot = picture.transform.plot;
  const QRectF strip(plot.left(), plot.bottom() + stripGap, plot.width(), stripHeight);
  QPainterPath rounded;
  rounded.addRoundedRect(strip, 3.0, 3.0);
  QPainterPath frame;
  frame.addRoundedRect(strip.adjusted(0.5, 0.5, -0.5, -0.5), 3.0, 3.0);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  if (picture.function.points.empty()) {
    painter.fillPath(rounded, picture.colors.grid);
  } else {
    painter.setClipPath(rounded);
    painter.drawImage(strip, colorRow(picture, painter.device()->devicePixelRatioF()));
    painter.setClipping(false);
  }
  // White ends in a light window, black ones in a dark.
  painter.setPen(QPen(picture.colors.outline, 1.0));
  painter.drawPath(frame);
  painter.restore();
}

constexpr double besideValue = 12.0; // from the value's line, pixels
constexpr double fromEdge = 2.0;     // of the plot
constexpr double fromCurve = 2.0;

bool coversPoint(const QRectF& box, const PlotTransform& transform, const TransferFunction& function) {
  constexpr double reach = pointDiameter / 2.0 + fromCurve;
  const QRectF kept = box.adjusted(-reach, -reach, reach, reach);
  return std::ranges::any_of(function.points, [&](const ControlPoint& point) {
    return kept.contains(positionOf(transform, point));
  });
}

const ControlPoint* toldPoint(const CanvasPicture& picture) {
  const std::vector<ControlPoint>& points = picture.function.points;
  return picture.readOut && *picture.readOut < points.size() ? &points[*picture.readOut] : nullptr;
}

constexpr double gripHalfWidth = 14.0;

QColor withAlpha(QColor color, int alpha) {
  color.setAlpha(alpha);
  return color;
}

void paintBox(QPainter& painter, const CanvasPicture& picture, const QString& text, const QRectF& box) {
  painter.setPen(QPen(picture.colors.border, 1.0));
  painter.setBrush(picture.colors.raised);
  painter.drawRoundedRect(box, 4.0, 4.0);
  painter.setPen(picture.colors.text);
  painter.drawText(box, Qt::AlignCenter, text);
}

QSizeF boxSize(const QPainter& painter, const QString& text) {
  return painter.fontMetrics().size(Qt::TextSingleLine, text) + QSizeF(12.0, 6.0);
}

void paintTissueBand(QPainter& painter, const CanvasPicture& picture) {
  const std::optional<Tissue> tissue = toldTissue(picture);
  if (!tissue)
    return;
  const QRectF& plot = picture.transform.plot;
  const double from = std::max(plot.left(), xOfValue(picture.transform, tissue->range.lowest));
  const double to = std::min(plot.right(), xOfValue(picture.transform, tissue->range.highest));
  painter.fillRect(QRectF(QPointF(from, plot.top()), QPointF(to, plot.bottom())),
                   withAlpha(picture.colors.accent, 26));
}

// Each over its values; of a name with several parts the first, where that has room.
void paintTissueNames(QPainter& painter, const CanvasPicture& picture) {
  constexpr double beside = 4.0;
  if (picture.unit != QLatin1String("HU") || picture.subject != CurveSubject::value)
    return;
  const QRectF& plot = picture.transform.plot;
  painter.save();
  QFont font = painter.font();
  font.setPointSizeF(0.85 * font.pointSizeF());
  painter.setFont(font);
  painter.setPen(picture.colors.secondaryText);
  double free = plot.left();
  for (const Tissue& tissue : allTissues()) {
    const double from = std::max(plot.left(), xOfValue(picture.transform, tissue.range.lowest));
    const double to = std::min(plot.right(), xOfValue(picture.transform, tissue.range.highest));
    if (to <= from)
      continue;
    const QString name = tissue.name.section(QLatin1Char(','), 0, 0);
    const double width = painter.fontMetrics().horizontalAdvance(name);
    const double left = std::max(plot.left(), (from + to) / 2.0 - width / 2.0);
    // A narrow range may lend its neighbours' gaps, but covers no other name.
    if (width > 3.0 * (to - from) || left < free || left + width > plot.right())
      continue;
    painter.drawText(tissueNamePlace(picture, left, width + 1.0), Qt::AlignCenter, name);
    free = left + width + beside;
    painter.drawLine(QPointF(from, plot.top()), QPointF(from, plot.top() + 3.0));
    painter.drawLine(QPointF(to, plot.top()), QPointF(to, plot.top() + 3.0));
  }
  painter.restore();
}

// The curve's colours below it.
void paintColors(QPainter& painter, const CanvasPicture& picture) {
  const QRectF& plot = picture.transform.plot;
  const QPolygonF line = curvePolygon(picture.transform, picture.function);
  if (line.isEmpty())
    return;
  QPolygonF area = line;
  area << QPointF(plot.right(), plot.bottom()) << QPointF(plot.left(), plot.bottom());
  QBrush colors(colorRow(picture));
  colors.setTransform(QTransform::fromTranslate(plot.left(), 0.0));
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors);
  painter.setOpacity(colorsOpacity);
  painter.drawPolygon(area);
  painter.setOpacity(1.0);
}

void paintCurveLine(QPainter& painter, const CanvasPicture& picture) {
  const QPolygonF line = curvePolygon(picture.transform, picture.function);
  painter.setBrush(Qt::NoBrush);
  const bool hovered = picture.hoveredPart == CurveHit::Part::curve;
  painter.setPen(QPen(hovered ? picture.colors.accent : picture.colors.curve, 1.75, Qt::SolidLine,
                      Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(line);
}

// An end of the bar; one beyond the visible values is an arrow that points there.
void paintBarEnd(QPainter& painter, const CanvasPicture& picture, const QPointF& end, bool visible) {
  if (visible) {
    painter.drawRoundedRect(QRectF(end.x() - 2.0, end.y() - 6.0, 4.0, 12.0), 2.0, 2.0);
    return;
  }
  const double way = end.x() < picture.transform.plot.center().x() ? -1.0 : 1.0;
  painter.drawPolygon(QPolygonF({end, end + QPointF(-7.0 * way, -5.0), end + QPointF(-7.0 * way, 5.0)}));
}

void paintBar(QPainter& painter, const CanvasPicture& picture) {
  const auto bar = curveBar(picture.transform, picture.function);
  if (!bar)
    return;
  const QRectF& plot = picture.transform.plot;
  const QRectF lane(plot.left() - 6.0, 0.0, plot.width() + 12.0, plot.top());
  const QColor idle = picture.colors.secondaryText;
  const QColor lively = picture.colors.accent;
  painter.save();
  painter.setClipRect(lane);
  painter.setPen(QPen(withAlpha(idle, 140), 2.0, Qt::SolidLine, Qt::FlatCap));
  painter.drawLine(bar->start, bar->end);
  painter.setPen(Qt::NoPen);
  painter.setBrush(picture.hoveredPart == CurveHit::Part::barEnd ? lively : idle);
  if (picture.function.points.size() > 1 || !bar->startVisible) {
    paintBarEnd(painter, picture, bar->start, bar->startVisible);
    paintBarEnd(painter, picture, bar->end, bar->endVisible);
  }
  painter.setBrush(picture.hoveredPart == CurveHit::Part::barGrip ? lively : idle);
  painter.drawRoundedRect(
      QRectF(bar->grip.x() - gripHalfWidth, bar->grip.y() - 5.0, 2.0 * gripHalfWidth, 10.0), 5.0, 5.0);
  painter.setPen(QPen(picture.colors.window, 1.5));
  for (const double dx : {-4.0, 0.0, 4.0})
    painter.drawLine(bar->grip + QPointF(dx, -2.0), bar->grip + QPointF(dx, 2.0));
  painter.restore();
}

void paintValueLine(QPainter& painter, const CanvasPicture& picture, double value, Qt::PenStyle style,
                    const QString& label) {
  const QRectF& plot = picture.transform.plot;
  const double x = xOfValue(picture.transform, value);
  if (x < plot.left() || x > plot.right())
    return;
  painter.setPen(QPen(picture.colors.accent, 1.25, style));
  painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
  paintBox(painter, picture, label,
           clearPlace(picture.transform, picture.function, boxSize(painter, label), x));
}

void paintMarkedValues(QPainter& painter, const CanvasPicture& picture) {
  if (picture.pinnedValue)
    paintValueLine(
        painter, picture, *picture.pinnedValue, Qt::SolidLine,
        QObject::tr("pinned: %1").arg(valueText(*picture.pinnedValue, picture.unit, picture.decimals)));
  if (picture.mark)
    paintValueLine(
        painter, picture, picture.mark->value, Qt::DashLine,
        (picture.mark->isProbed ? QObject::tr("under the pointer: %1") : QObject::tr("at the crosshair: %1"))
            .arg(valueText(picture.mark->value, picture.unit, picture.decimals)));
}

void paintPoints(QPainter& painter, const CanvasPicture& picture) {
  for (std::size_t i = 0; i < picture.function.points.size(); ++i) {
    const ControlPoint& point = picture.function.points[i];
    const QPointF centre = positionOf(picture.transform, point);
    const QRectF& plot = picture.transform.plot;
    if (centre.x() < plot.left() - pointDiameter || centre.x() > plot.right() + pointDiameter)
      continue;
    if (contains(picture.selected, i) || picture.hoveredPoint == i) {
      painter.setBrush(Qt::NoBrush);
      painter.setPen(
          QPen(contains(picture.selected, i) ? picture.colors.accent : picture.colors.secondaryText, 2.0));
      painter.drawEllipse(centre, pointDiameter / 2.0 + 3.0, pointDiameter / 2.0 + 3.0);
    }
    painter.setBrush(toQColor(point.color));
    painter.setPen(QPen(picture.colors.curve, 1.5));
    painter.drawEllipse(centre, pointDiameter / 2.0 - 0.75, pointDiameter / 2.0 - 0.75);
  }
}

void paintReadOut(QPainter& painter, const CanvasPicture& picture) {
  if (!picture.readOut || *picture.readOut >= picture.function.points.size())
    return;
  const QPointF centre = positionOf(picture.transform, picture.function.points[*picture.readOut]);
  const QRectF& plot = picture.transform.plot;
  if (centre.x() < plot.left() || centre.x() > plot.right())
    return;
  const QString text = readOutText(picture);
  paintBox(painter, picture, text,
           placeAbove(picture.transform, picture.function, boxSize(painter, text), centre));
}

void paintHoverLine(QPainter& painter, const CanvasPicture& picture) {
  if (!picture.hoveredValue || picture.readOut)
    return;
  const QRectF& plot = picture.transform.plot;
  const double x = xOfValue(picture.transform, *picture.hoveredValue);
  painter.setPen(QPen(withAlpha(picture.colors.secondaryText, 130), 1.0));
  painter.drawLine(QPointF(x, plot.top()), QPointF(x, plot.bottom()));
}

// Where it hides neither the curve nor the bar that spans it.
void paintHoverText(QPainter& painter, const CanvasPicture& picture) {
  if (!picture.hoveredValue || picture.readOut)
    return;
  const QString text = readOutText(picture);
  paintBox(painter, picture, text,
           clearPlace(picture.transform, picture.function, boxSize(painter, text),
                      xOfValue(picture.transform, *picture.hoveredValue)));
}

// On a plate where a histogram would disturb the reading.
void paintHint(QPainter& painter, const CanvasPicture& picture) {
  if (picture.hint.isEmpty())
    return;
  const QRectF room = picture.transform.plot.adjusted(24.0, 4.0, -24.0, -4.0);
  const int flags = Qt::AlignCenter | Qt::TextWordWrap;
  const QRectF text = painter.boundingRect(room, flags, picture.hint);
  if (!picture.histogram.area.isNull()) {
    painter.setPen(QPen(picture.colors.border, 1.0));
    painter.setBrush(picture.colors.raised);
    painter.drawRoundedRect(text.adjusted(-12.0, -6.0, 12.0, 6.0), 4.0, 4.0);
  }
  painter.setPen(picture.colors.text);
  painter.drawText(room, flags, picture.hint);
}

// The value that the plot tells of, scalar units: that of the point whose numbers show, otherwise the one
// under the pointer; absent where there is neither.
std::optional<double> toldValue(const CanvasPicture& picture) {
  const ControlPoint* point = toldPoint(picture);
  return point ? std::optional(point->value) : picture.hoveredValue;
}

} // namespace

QRectF plotWithin(const QSizeF& size, CurveSubject subject) {
  const double below = ticksBelow + (hasColors(subject) ? stripBelow : 0.0);
  return {plotLeft, plotTop, std::max(20.0, size.width() - plotLeft - plotRight),
          std::max(20.0, size.height() - plotTop - below)};
}

QImage colorRow(const CanvasPicture& picture, double columnsPerPixel) {
  const int columns = std::max(1, static_cast<int>(columnsPerPixel * picture.transform.plot.width()));
  QImage row(columns, 1, QImage::Format_RGB32);
  for (int i = 0; i < columns; ++i) {
    const double value =
        valueAtX(picture.transform, picture.transform.plot.left() + (i + 0.5) / columnsPerPixel);
    row.setPixelColor(i, 0, toQColor(classify(picture.function, value).color));
  }
  return row;
}

void paintAxes(QPainter& painter, const CanvasPicture& picture) {
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.fillRect(picture.transform.plot, picture.colors.base);
  if (picture.histogram.area.isNull() && picture.function.points.empty())
    return; // axes of nothing
  const QRectF& plot = picture.transform.plot;
  const AxisColors colors{picture.colors.grid, picture.colors.secondaryText, picture.colors.secondaryText};
  const double numbersTop = plot.bottom() + (hasColors(picture.subject) ? stripBelow : 0.0) + 3.0;
  const int most = std::max(2, static_cast<int>(plot.width() / pixelsPerTick));
  paintAxisAcross(painter, picture.transform, linearTicks(picture.transform.visible, most), axisText(picture),
                  {plot}, numbersTop, 20.0, colors);
  paintAxisUp(painter, picture.transform, opacityTicks(picture.transform), QObject::tr("Opacity"), 8.0, 6.0,
              colors);
  if (hasColors(picture.subject))
    paintColorStrip(painter, picture);
}

std::optional<Tissue> toldTissue(const CanvasPicture& picture) {
  const std::optional<double> value = toldValue(picture);
  return value && picture.unit == QLatin1String("HU") ? tissueAt(*value) : std::nullopt;
}

QString readOutText(const CanvasPicture& picture) {
  const std::optional<double> value = toldValue(picture);
  if (!value)
    return {};
  QString text = valueText(*value, picture.unit, picture.decimals);
  if (const ControlPoint* point = toldPoint(picture)) // of points at one value each has its own opacity
    text += QObject::tr(" · opacity %1").arg(opacityText(point->opacity));
  else if (!picture.function.points.empty())
    text += QObject::tr(" · opacity %1").arg(opacityText(classify(picture.function, *value).opacity));
  if (const std::optional<Tissue> tissue = toldTissue(picture))
    text += QStringLiteral(" · ") + tissue->name;
  return text;
}

QRectF tissueNamePlace(const CanvasPicture& picture, double left, double width) {
  constexpr double height = 14.0;
  const QRectF& plot = picture.transform.plot;
  const QPolygonF curve =
      picture.function.points.empty() ? QPolygonF() : curvePolygon(picture.transform, picture.function);
  const QPolygonF edge = picture.histogram.line.translated(plot.topLeft());
  const QRectF highest(left, plot.top() + 1.0, width, height);
  const QRectF lowest = highest.translated(0.0, plot.height() - height - 2.0);
  if (!runsThrough(curve, highest))
    return highest;
  for (QRectF row = lowest; row.top() > highest.top(); row.translate(0.0, -height))
    if (!runsThrough(curve, row) && !runsThrough(edge, row))
      return row;
  return lowest;
}

QRectF clearPlace(const PlotTransform& transform, const TransferFunction& function, const QSizeF& size,
                  double x) {
  const QRectF room = transform.plot.adjusted(fromEdge, fromEdge, -fromEdge, -fromEdge);
  const QPolygonF curve = curvePolygon(transform, function);
  const auto boxAt = [&](double left, double top) {
    const double rightmost = std::max(room.left(), room.right() - size.width());
    return QRectF(QPointF(std::clamp(left, room.left(), rightmost), top), size);
  };
  const double bottom = room.bottom() - size.height();
  std::vector<double> tops{room.top(), bottom};
  for (double top = room.top() + size.height(); top < bottom; top += size.height())
    tops.push_back(top);
  std::optional<QRectF> besidePoints;
  for (const double top : tops)
    for (const double left : {x - size.width() / 2.0, x + besideValue, x - besideValue - size.width()}) {
      const QRectF box = boxAt(left, top);
      if (coversPoint(box, transform, function))
        continue;
      if (!runsThrough(curve, box.adjusted(-fromCurve, -fromCurve, fromCurve, fromCurve)))
        return box;
      besidePoints = besidePoints.value_or(box);
    }
  return besidePoints.value_or(boxAt(x - size.width() / 2.0, room.top()));
}

QRectF placeAbove(const PlotTransform& transform, const TransferFunction& function, const QSizeF& size,
                  const QPointF& centre) {
  const QRectF room = transform.plot.adjusted(fromEdge, fromEdge, -fromEdge, -fromEdge);
  const double left = std::clamp(centre.x() - size.width() / 2.0, room.left(),
                                 std::max(room.left(), room.right() - size.width()));
  const QRectF above(QPointF(left, centre.y() - besideValue - size.height()), size);
  return room.contains(above) && !coversPoint(above, transform, function)
             ? above
             : clearPlace(transform, function, size, centre.x());
}

void paintCurve(QPainter& painter, const CanvasPicture& picture) {
  const QRectF& plot = picture.transform.plot;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.save();
  painter.setClipRect(plot.adjusted(-1.0, -1.0, 1.0, 1.0));
  if (!picture.histogram.area.isNull())
    painter.drawPixmap(plot.topLeft(), picture.histogram.area);
  paintTissueBand(painter, picture);
  paintColors(painter, picture);
  painter.drawPixmap(plot.topLeft(), picture.histogram.edge);
  paintTissueNames(painter, picture);
  paintCurveLine(painter, picture);
  paintHoverLine(painter, picture);
  paintMarkedValues(painter, picture);
  paintHint(painter, picture);
  painter.restore();

  paintBar(painter, picture);
  paintPoints(painter, picture);
  paintHoverText(painter, picture);
  paintReadOut(painter, picture);
  if (picture.band) {
    painter.setPen(QPen(picture.colors.accent, 1.0));
    painter.setBrush(withAlpha(picture.colors.accent, 36));
    painter.drawRect(*picture.band);
  }
  if (picture.focused) {
    painter.setPen(QPen(picture.colors.accent, 1.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(plot.adjusted(-0.5, -0.5, 0.5, 0.5), 2.0, 2.0);
  }
}

} // namespace limn
