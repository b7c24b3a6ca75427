// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/accuracy/ChartPicture.h"

#include "widgets/ValueText.h"
#include "widgets/accuracy/PointUse.h"
#include "widgets/plot/Axes.h"

#include <QGuiApplication>
#include <QObject>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double leastFloor = 0.0005;

double errorOf(const ImageError& error, ErrorMeasure measure) {
  return measure == ErrorMeasure::mean ? error.mean : error.p99_9;
}

// A tolerance counts as the step that it replaces: larger is coarser.
double coarseness(const OperatingPoint& point) {
  return point.toleranceLevels.value_or(point.stepVoxels);
}

constexpr double ringSize = 1.4; ///< of a mark, in text sizes
constexpr double markSize = 0.85;
// A clock may tell 0 ms; a logarithm cannot.
constexpr double leastShownMs = 0.001;

QFont textFont(const ChartPicture& picture, double scale = 0.95) {
  QFont font = QGuiApplication::font();
  font.setPixelSize(std::max(8, qRound(scale * picture.textSize)));
  return font;
}

/// Where everything stands.
struct ChartLayout {
  PlotTransform plot;
  std::vector<AxisTick> times;
  std::vector<AxisTick> errors;
  double numbersTop = 0.0; ///< of the times
  double timeTitleTop = 0.0;
  double errorTitleX = 0.0; ///< its middle
  LegendLayout legend;
  QPointF legendCorner;
};

// From the least to the most of all that is shown; the errors with one level.
void setRanges(PlotTransform& plot, const ChartPicture& picture) {
  ValueRange ms{1e9, leastShownMs}, levels{1.0, 1.0};
  for (const ChartCurve& curve : picture.curves)
    for (const ChartMark& mark : curve.marks) {
      ms = {std::min(ms.lowest, mark.leastMs), std::max(ms.highest, mark.mostMs)};
      levels = {std::min(levels.lowest, mark.error), std::max(levels.highest, mark.error)};
    }
  if (const std::optional<QuarterError> quarter = quarterError(picture)) {
    ms.highest = std::max(ms.highest, quarter->ms);
    levels.lowest = std::min(levels.lowest, quarter->error);
  }
  const double leastMs = std::max(ms.lowest, leastShownMs);
  plot.acrossScale = plot.upScale = AxisScale::logarithmic;
  plot.visible = logarithmicRange(leastMs, std::max(ms.highest, leastMs));
  plot.up = logarithmicRange(levels.lowest, levels.highest);
}

// Title, legend and axes take what their texts need, the plot has the rest.
ChartLayout layoutOf(const ChartPicture& picture) {
  const double text = picture.textSize;
  const double margin = 0.6 * text;
  const QFontMetricsF metrics(textFont(picture));
  ChartLayout layout;
  QRectF rest = QRectF(QPointF(), picture.size).adjusted(margin, margin, -1.2 * margin, -margin);
  layout.plot.plot = rest;
  if (picture.curves.empty())
    return layout;
  setRanges(layout.plot, picture);
  layout.times = logarithmicTicks(layout.plot.visible, picture.timeTicks);
  layout.errors = logarithmicTicks(layout.plot.up, picture.errorTicks);
  layout.legend = legendLayout(legendEntries(picture), textFont(picture),
                               picture.legendAtRight ? 0.0 : rest.width() - margin);
  rest.setTop(rest.top() + (picture.title.isEmpty() ? 0.3 : 1.6) * text);
  if (picture.legendAtRight)
    rest.setRight(rest.right() - layout.legend.width - text);
  else
    rest.setBottom(rest.bottom() - layout.legend.height);
  layout.timeTitleTop = rest.bottom() - metrics.height() - 0.2 * text;
  layout.numbersTop = layout.timeTitleTop - 1.3 * metrics.height();
  layout.errorTitleX = rest.left() + 0.5 * metrics.height();
  double widest = 0.0;
  for (const AxisTick& tick : layout.errors)
    widest = std::max(widest, metrics.horizontalAdvance(tick.text));
  rest.setLeft(layout.errorTitleX + 0.5 * metrics.height() + widest + text);
  rest.setBottom(layout.numbersTop - 0.3 * text);
  layout.plot.plot = rest;
  if (!picture.legendAtRight && !layout.times.empty()) { // the last number stands below its line, whole
    const AxisTick& last = layout.times.back();
    const double share = (xOfValue(layout.plot, last.value) - rest.left()) / rest.width();
    const double most = picture.size.width() - 0.5 * metrics.horizontalAdvance(last.text) - 1.0;
    rest.setRight(std::min(rest.right(), rest.left() + (most - rest.left()) / share));
    layout.plot.plot = rest;
  }
  layout.legendCorner =
      picture.legendAtRight
          ? QPointF(rest.right() + text, rest.center().y() - 0.5 * layout.legend.height)
          : QPointF(1.5 * margin, picture.size.height() - layout.legend.height - 0.5 * margin);
  return layout;
}

QPointF placeOf(const PlotTransform& plot, double ms, double levels) {
  return {xOfValue(plot, std::max(ms, leastShownMs)), yOfOpacity(plot, levels)};
}

QPointF placeOf(const PlotTransform& plot, const ChartMark& mark) {
  return placeOf(plot, mark.ms, mark.error);
}

QPolygonF lineOf(const PlotTransform& plot, const ChartCurve& curve) {
  QPolygonF line;
  for (const ChartMark& mark : curve.marks)
    line << placeOf(plot, mark);
  return line;
}

// The law of chance, from where the fewest paths lie to a quarter of the error of the most.
QPolygonF lineOfChance(const ChartPicture& picture, const PlotTransform& plot) {
  const std::optional<QuarterError> quarter = quarterError(picture);
  if (!quarter)
    return {};
  const double least = picture.curves.front().marks.front().ms;
  return {placeOf(plot, least, quarter->error * std::sqrt(quarter->ms / std::max(least, leastShownMs))),
          placeOf(plot, quarter->ms, quarter->error)};
}

// From fast to slow. What is best by the 99.9th percentile need not be so by the mean.
std::vector<ChartMark> bestTradeOffs(const ChartPicture& picture) {
  std::vector<ChartMark> best;
  if (picture.measure == ErrorMeasure::mean)
    return best;
  for (const ChartCurve& curve : picture.curves)
    std::ranges::copy_if(curve.marks, std::back_inserter(best), &ChartMark::isPareto);
  std::ranges::sort(best, {}, &ChartMark::ms);
  return best;
}

void paintEmpty(QPainter& painter, const ChartPicture& picture, const QRectF& plot) {
  painter.setPen(chartColors(picture.style).secondaryText);
  const double margin = picture.textSize;
  painter.drawText(plot.adjusted(margin, margin, -margin, -margin), Qt::AlignCenter | Qt::TextWordWrap,
                   picture.report.points.empty()
                       ? QObject::tr("Nothing is measured yet.")
                       : QObject::tr("Not converged: the exact picture still changes with finer steps, so no "
                                     "error is known."));
}

void paintAxes(QPainter& painter, const ChartPicture& picture, const ChartLayout& layout) {
  const ChartColors colors = chartColors(picture.style);
  const QRectF& plot = layout.plot.plot;
  const double height = QFontMetricsF(painter.font()).height();
  const AxisColors axes{colors.grid, colors.secondaryText, colors.text};
  paintAxisAcross(painter, layout.plot, layout.times, {}, {plot}, layout.numbersTop, height, axes);
  // Where it is cut, the list below still says of which error.
  paintAxisUp(painter, layout.plot, layout.errors,
              picture.measure == ErrorMeasure::mean ? QObject::tr("Error, levels of 255 (mean)")
                                                    : QObject::tr("Error, levels of 255 (99.9th percentile)"),
              layout.errorTitleX, 0.4 * picture.textSize, axes);
  painter.setPen(colors.text);
  painter.drawText(QRectF(plot.left(), layout.timeTitleTop, plot.width(), height), Qt::AlignCenter,
                   QObject::tr("Time per picture, ms"));
  painter.setPen(QPen(colors.border, 1.0));
  painter.drawPolyline(QPolygonF{plot.topLeft(), plot.bottomLeft(), plot.bottomRight()});
}

void paintTradeOffs(QPainter& painter, const ChartPicture& picture, const PlotTransform& plot) {
  QPolygonF line;
  for (const ChartMark& mark : bestTradeOffs(picture))
    line << placeOf(plot, mark);
  painter.setPen(QPen(chartColors(picture.style).trade, 0.9 * picture.textSize, Qt::SolidLine, Qt::RoundCap,
                      Qt::RoundJoin));
  painter.drawPolyline(line);
}

// A mark too small to be told from none is hollow.
void paintCurve(QPainter& painter, const ChartPicture& picture, const PlotTransform& plot,
                const ChartCurve& curve, const CurveLook& look) {
  painter.setPen(QPen(look.color, 0.13 * picture.textSize, look.isDashed ? Qt::DashLine : Qt::SolidLine,
                      Qt::RoundCap, Qt::RoundJoin));
  painter.drawPolyline(lineOf(plot, curve));
  painter.setPen(QPen(look.color, 0.1 * picture.textSize));
  for (const ChartMark& mark : curve.marks) {
    painter.setBrush(mark.isBelowFloor ? chartColors(picture.style).background : look.color);
    paintMark(painter, look.shape, placeOf(plot, mark), markSize * picture.textSize);
  }
}

void paintRings(QPainter& painter, const ChartPicture& picture, const PlotTransform& plot) {
  painter.setPen(QPen(chartColors(picture.style).secondaryText, std::max(1.0, 0.06 * picture.textSize)));
  painter.setBrush(Qt::NoBrush);
  for (const ChartMark& mark : bestTradeOffs(picture))
    paintMark(painter, MarkShape::circle, placeOf(plot, mark), ringSize * picture.textSize);
}

// Where a label of this size can stand above or below the line at `y` and covers no curve, as far to the
// right as possible.
std::optional<QPointF> freeCorner(const ChartPicture& picture, const PlotTransform& transform,
                                  const QSizeF& size, double y) {
  const QRectF& plot = transform.plot;
  const double text = picture.textSize;
  const QPolygonF ofChance = lineOfChance(picture, transform);
  const auto isFree = [&](const QRectF& place) {
    const QRectF room = place.adjusted(-0.6 * text, -0.2 * text, 0.6 * text, 0.2 * text);
    return !runsThrough(ofChance, room) && std::ranges::none_of(picture.curves, [&](const ChartCurve& curve) {
      return runsThrough(lineOf(transform, curve), room);
    });
  };
  for (double x = plot.right() - size.width() - 6.0; x > plot.left() + 6.0; x -= 0.5 * text)
    for (const double top : {y - size.height() - 2.0, y + 2.0})
      if (isFree(QRectF(QPointF(x, top), size)))
        return QPointF(x, top);
  return std::nullopt;
}

// Where its label has no room, a shorter one does.
void paintOneLevel(QPainter& painter, const ChartPicture& picture, const PlotTransform& transform) {
  const QRectF& plot = transform.plot;
  const double y = yOfOpacity(transform, 1.0);
  painter.setPen(QPen(chartColors(picture.style).text, 1.0, Qt::DashLine));
  painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
  const QFontMetricsF metrics(painter.font());
  for (const QString& text : {QObject::tr("1 level: accurate to the screen"), QObject::tr("1 level")}) {
    const QSizeF size(metrics.horizontalAdvance(text) + 4.0, metrics.height());
    const std::optional<QPointF> corner = freeCorner(picture, transform, size, y);
    if (corner)
      return painter.drawText(QRectF(*corner, size), Qt::AlignCenter, text);
  }
}

// A thin line through the point of most paths, and hollow where it ends; what it says stands to the left,
// below it, where no curve runs.
void paintChance(QPainter& painter, const ChartPicture& picture, const PlotTransform& plot) {
  const QPolygonF line = lineOfChance(picture, plot);
  if (line.isEmpty())
    return;
  const QuarterError quarter = *quarterError(picture);
  const double unit = picture.textSize;
  const ChartColors colors = chartColors(picture.style);
  painter.setPen(QPen(colors.secondaryText, std::max(1.0, 0.06 * unit)));
  painter.drawPolyline(line);
  painter.setBrush(colors.background);
  paintMark(painter, MarkShape::circle, line.back(), 0.7 * markSize * unit);
  const double height = QFontMetricsF(painter.font()).height();
  const auto write = [&](const QPointF& rightEnd, const QString& text) {
    const QRectF row(plot.plot.left(), rightEnd.y() - 0.5 * height, rightEnd.x() - plot.plot.left(), height);
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, text);
  };
  const double seconds = 1e-3 * quarter.ms;
  const QString time = seconds < 10.0 ? digitsNumber(seconds, 2) : plainNumber(seconds, 0);
  const QPointF leftOfEnd = line.back() - QPointF(0.7 * unit, 0.0);
  // Where a panel is narrow a shorter one has room.
  for (const QString& text :
       {QObject::tr("a quarter of the error: %1 paths, %2 s"), QObject::tr("%1 paths, %2 s")})
    if (const QString whole = text.arg(quarter.paths).arg(time);
        QFontMetricsF(painter.font()).horizontalAdvance(whole) <= leftOfEnd.x() - plot.plot.left()) {
      write(leftOfEnd, whole);
      break;
    }
  // Along the part that nobody measured, which is two thirds of a decade of errors high.
  const ChartMark& last = picture.curves.front().marks.back();
  const QPointF middle = 0.5 * (placeOf(plot, last) + line.back());
  write(middle + QPointF(-0.8 * unit, 0.4 * unit), QObject::tr("law of chance, 1/√n"));
}

// A whisker from the least to the most time, where it reaches beyond the mark.
void paintSpread(QPainter& painter, const PlotTransform& plot, const ChartMark& mark, double unit) {
  const QPointF middle = placeOf(plot, mark);
  for (const double ms : {mark.leastMs, mark.mostMs}) {
    const QPointF end = placeOf(plot, ms, mark.error);
    const double from = middle.x() + (end.x() < middle.x() ? -0.45 : 0.45) * unit;
    if (std::abs(end.x() - middle.x()) <= 0.45 * unit)
      continue;
    painter.drawLine(QPointF(from, middle.y()), end);
    painter.drawLine(end - QPointF(0.0, 0.25 * unit), end + QPointF(0.0, 0.25 * unit));
  }
}

// An arrow and what the error is known to be below, to its left where it would leave the plot.
void paintFloor(QPainter& painter, const PlotTransform& plot, const ChartMark& mark, double unit,
                const QColor& textColor) {
  const QPointF top = placeOf(plot, mark) + QPointF(0.0, 0.5 * unit);
  const QPointF tip = top + QPointF(0.0, 0.7 * unit);
  painter.drawLine(top, tip);
  painter.drawPolyline(QPolygonF{tip + QPointF(-0.22, -0.25) * unit, tip, tip + QPointF(0.22, -0.25) * unit});
  painter.setPen(textColor);
  const QString bound = QObject::tr("< %1").arg(digitsNumber(mark.error, 2));
  const double width = QFontMetricsF(painter.font()).horizontalAdvance(bound);
  const bool fitsRight = tip.x() + 0.6 * unit + width <= plot.plot.right();
  painter.drawText(tip + QPointF(fitsRight ? 0.6 * unit : -0.6 * unit - width, 0.2 * unit), bound);
}

void paintNotes(QPainter& painter, const ChartPicture& picture, const PlotTransform& plot) {
  const double unit = picture.textSize;
  if (picture.measure == ErrorMeasure::p99_9)
    paintOneLevel(painter, picture, plot);
  for (std::size_t i = 0; i < picture.curves.size(); ++i)
    for (const ChartMark& mark : picture.curves[i].marks) {
      painter.setPen(QPen(curveLook(picture.style, static_cast<int>(i)).color, 0.09 * unit, Qt::SolidLine,
                          Qt::RoundCap, Qt::RoundJoin));
      paintSpread(painter, plot, mark, unit);
      if (mark.isBelowFloor)
        paintFloor(painter, plot, mark, unit, chartColors(picture.style).secondaryText);
    }
}

void paintChosen(QPainter& painter, const ChartPicture& picture) {
  QColor accent = chartColors(picture.style).accent;
  painter.setPen(QPen(accent, 2.0));
  accent.setAlphaF(0.25f);
  const auto ring = [&](std::optional<std::size_t> point, double size, const QBrush& filling) {
    const std::optional<QPointF> place = point ? positionOf(picture, *point) : std::nullopt;
    painter.setBrush(filling);
    if (place)
      paintMark(painter, MarkShape::circle, *place, size * picture.textSize);
  };
  ring(picture.current, 2.0, accent);
  ring(picture.hovered, 1.6, Qt::NoBrush);
}

// The smallest error that can be shown: what the exact picture allows, at least 0.0005 level.
double chartFloor(const AccuracyReport& report, ErrorMeasure measure) {
  const double least =
      measure == ErrorMeasure::mean ? leastMean(report.reference) : leastP99_9(report.reference);
  return std::max(least, leastFloor);
}

} // namespace

std::vector<ChartCurve> chartCurves(const AccuracyReport& report, ErrorMeasure measure) {
  std::vector<ChartCurve> curves;
  if (!report.reference.converged)
    return curves;
  const double floor = chartFloor(report, measure);
  for (std::size_t i = 0; i < report.points.size(); ++i) {
    const MeasuredPoint& point = report.points[i];
    const std::string family = familyOf(point.point);
    auto curve = std::find_if(curves.begin(), curves.end(),
                              [&](const ChartCurve& known) { return known.family == family; });
    if (curve == curves.end())
      curve = curves.insert(curves.end(), ChartCurve{family, {}});
    const double error = errorOf(point.error, measure);
    curve->marks.push_back({i, point.ms.median, point.ms.least, point.ms.most, std::max(error, floor),
                            error < floor, point.isPareto});
  }
  for (ChartCurve& curve : curves)
    std::stable_sort(curve.marks.begin(), curve.marks.end(), [&](const ChartMark& a, const ChartMark& b) {
      return coarseness(report.points[a.index].point) > coarseness(report.points[b.index].point);
    });
  return curves;
}

std::optional<QuarterError> quarterError(const ChartPicture& picture) {
  if (!picture.report.reference.isByChance || picture.curves.empty())
    return std::nullopt;
  const ChartMark& most = picture.curves.front().marks.back();
  const std::optional<int> paths = picture.report.points[most.index].point.paths;
  if (!paths || most.isBelowFloor)
    return std::nullopt;
  return QuarterError{16 * *paths, 16.0 * most.ms, most.error / 4.0};
}

PlotTransform chartPlot(const ChartPicture& picture) {
  return layoutOf(picture).plot;
}

std::vector<LegendEntry> legendEntries(const ChartPicture& picture) {
  std::vector<LegendEntry> entries;
  for (const ChartCurve& curve : picture.curves) {
    const CurveLook look = curveLook(picture.style, static_cast<int>(entries.size()));
    // All points of a curve belong to one family.
    const OperatingPoint& point = picture.report.points[curve.marks.front().index].point;
    entries.push_back({picture.plainNames ? familyText(point) : QString::fromStdString(curve.family),
                       look.color, look.shape, markSize * picture.textSize, true});
  }
  if (!bestTradeOffs(picture).empty())
    entries.push_back({QObject::tr("best trade-offs"), chartColors(picture.style).secondaryText,
                       MarkShape::circle, ringSize * picture.textSize, false});
  return entries;
}

std::optional<QPointF> positionOf(const ChartPicture& picture, std::size_t point) {
  for (const ChartCurve& curve : picture.curves)
    for (const ChartMark& mark : curve.marks)
      if (mark.index == point)
        return placeOf(chartPlot(picture), mark);
  return std::nullopt;
}

std::optional<std::size_t> pointNear(const ChartPicture& picture, const QPointF& position, double radius) {
  const PlotTransform plot = chartPlot(picture);
  std::vector<QPointF> places;
  std::vector<std::size_t> points;
  for (const ChartCurve& curve : picture.curves)
    for (const ChartMark& mark : curve.marks) {
      places.push_back(placeOf(plot, mark));
      points.push_back(mark.index);
    }
  const std::optional<std::size_t> nearest = nearestPlace(places, position, radius);
  return nearest ? std::optional(points[*nearest]) : std::nullopt;
}

void paintChart(QPainter& painter, const ChartPicture& picture) {
  const ChartLayout layout = layoutOf(picture);
  const PlotTransform& plot = layout.plot;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(textFont(picture));
  if (picture.curves.empty())
    return paintEmpty(painter, picture, plot.plot);
  paintAxes(painter, picture, layout);
  const QColor text = chartColors(picture.style).text;
  paintLegend(painter, legendEntries(picture), layout.legend, layout.legendCorner, text);
  painter.save();
  painter.setClipRect(plot.plot);
  paintTradeOffs(painter, picture, plot);
  paintChance(painter, picture, plot);
  for (std::size_t i = 0; i < picture.curves.size(); ++i)
    paintCurve(painter, picture, plot, picture.curves[i], curveLook(picture.style, static_cast<int>(i)));
  paintRings(painter, picture, plot);
  paintNotes(painter, picture, plot);
  paintChosen(painter, picture);
  painter.restore();
  painter.setFont(textFont(picture, 1.05));
  painter.setPen(text);
  painter.drawText(QRectF(0.0, 0.3 * picture.textSize, picture.size.width(), 1.6 * picture.textSize),
                   Qt::AlignCenter, picture.title);
}

QImage accuracyChartPicture(const AccuracyReport& report, const QSize& size, ChartStyle style,
                            ErrorMeasure measure) {
  const double text = std::clamp(std::min(size.width() / 70.0, size.height() / 42.0), 9.0, 60.0);
  const QString title = QObject::tr("%1 · %2 × %3 pixels · %4")
                            .arg(QString::fromStdString(report.scene))
                            .arg(report.size.x)
                            .arg(report.size.y)
                            .arg(QString::fromStdString(report.renderer));
  QImage picture(size, QImage::Format_RGB32);
  picture.fill(chartColors(style).background);
  QPainter painter(&picture);
  paintChart(painter, {.report = report,
                       .curves = chartCurves(report, measure),
                       .measure = measure,
                       .style = style,
                       .size = size,
                       .textSize = text,
                       .legendAtRight = 3 * size.width() >= 4 * size.height(),
                       .timeTicks = static_cast<int>(size.width() / (5.0 * text)),
                       .errorTicks = static_cast<int>(size.height() / (3.0 * text)),
                       .title = title});
  return picture;
}

} // namespace limn
