// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/figure/FigurePainting.h"

#include "widgets/ValueText.h"
#include "widgets/curve/picture/CurveGeometry.h"
#include "widgets/figure/FigureHeading.h"
#include "widgets/figure/LabelLegend.h"
#include "widgets/plot/Axes.h"
#include "widgets/theme/Theme.h"

#include <QFontMetricsF>
#include <QObject>
#include <QPainter>
#include <QPainterPath>
#include <QRegion>

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace limn {
namespace {

// What a figure is printed with on its page; each stands out from it by 4.5:1, lines by 3:1.
struct FigureColors {
  QColor page, text, quiet, line, grid;
};

// A transparent page is taken to be laid on a light one.
FigureColors colorsOn(FigureSettings::Page page) {
  if (page == FigureSettings::Page::black)
    return {QColor(0, 0, 0), QColor(255, 255, 255), QColor(178, 182, 188), QColor(150, 154, 160),
            QColor(60, 62, 66)};
  return {page == FigureSettings::Page::white ? QColor(255, 255, 255) : QColor(Qt::transparent),
          QColor(0, 0, 0), QColor(84, 88, 94), QColor(110, 114, 120), QColor(222, 224, 228)};
}

// In heights of the body's font.
constexpr double edgeInset = 0.6;
constexpr double barHeight = 0.28;
constexpr double haloWidth = 0.3;

// Of the picture's width.
constexpr double mostScaleBar = 0.3;

const QColor haloColor(0, 0, 0, 150);

double haloOf(const FigureLayout& layout) {
  return std::max(1.0, haloWidth * layout.textPixels);
}

// The letters stay as far from the corners as the scale bar reaches.
std::vector<EdgeLetter> edgeLetters(const OrientationLetters& letters, const QRectF& picture,
                                    const FigureLayout& layout) {
  const QFontMetricsF metrics(figureFont(layout));
  const double inset = edgeInset * layout.textPixels;
  std::vector<EdgeLetter> placed;
  const auto place = [&](const std::string& text, double x, double y, double alongX, double alongY) {
    const QString letter = QString::fromStdString(text);
    if (letter.isEmpty())
      return;
    const QSizeF size(metrics.horizontalAdvance(letter), metrics.height());
    placed.push_back({letter, {QPointF(x - alongX * size.width(), y - alongY * size.height()), size}});
  };
  place(letters.left, picture.left() + inset, picture.center().y(), 0.0, 0.5);
  place(letters.right, picture.right() - inset, picture.center().y(), 1.0, 0.5);
  place(letters.top, picture.center().x(), picture.top() + inset / 2.0, 0.5, 0.0);
  place(letters.bottom, picture.center().x(), picture.bottom() - inset / 2.0, 0.5, 1.0);
  return placed;
}

// Whole centimetres read better from a tenth of a metre on, thousandths as micrometres.
QString lengthText(double mm) {
  if (mm >= 10.0)
    return valueText(mm / 10.0, QObject::tr("cm"), decimalsFor(1.0));
  if (mm < 0.1)
    return valueText(mm * 1000.0, QObject::tr("µm"), decimalsFor(mm * 1000.0));
  return valueText(mm, QObject::tr("mm"), decimalsFor(mm));
}

std::optional<FigureScaleBar> scaleBarOn(const FigurePanel& panel, const QRectF& picture,
                                         const FigureLayout& layout) {
  const QSize pixels(static_cast<int>(picture.width()), static_cast<int>(picture.height()));
  const ScaleBar bar = scaleBar(mmPerPixelOf(panel, pixels), mostScaleBar * picture.width());
  if (!(bar.lengthMm > 0.0))
    return std::nullopt;
  const double inset = edgeInset * layout.textPixels;
  const double height = std::max(2.0, std::round(barHeight * layout.textPixels));
  FigureScaleBar placed;
  placed.bar = QRectF(picture.left() + inset, picture.bottom() - inset - height, bar.pixels, height);
  placed.text = lengthText(bar.lengthMm);
  const QFontMetricsF metrics(figureFont(layout));
  const double width = metrics.horizontalAdvance(placed.text);
  const double x = std::max(placed.bar.left(), placed.bar.center().x() - width / 2.0);
  placed.textPlace = QRectF(x, placed.bar.top() - metrics.height(), width, metrics.height());
  return placed;
}

// The edge is a path, the text stays text.
void paintOutlined(QPainter& painter, const QRectF& place, const QString& text, double halo) {
  const QFontMetricsF metrics(painter.font());
  const QPointF baseline(place.left(), place.top() + metrics.ascent());
  QPainterPath shape;
  shape.addText(baseline, painter.font(), text);
  painter.strokePath(shape, QPen(haloColor, halo, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setPen(Qt::white);
  painter.drawText(baseline, text);
}

/// Where the parts of a legend stand.
struct LegendParts {
  PlotTransform transform;
  QRectF bar;       ///< of colours
  double left = 0;  ///< where the legend begins, with the words beside its plot
  double line = 1;  ///< the width of a thin line
  double text = 10; ///< the height of the font
};

// The values over which a curve is shown: those between its outermost points with some room beside them, or
// the volume's where there are none.
ValueRange rangeOf(const TransferFunction& function, const Volume& volume) {
  const auto& points = function.points;
  if (points.empty() || !(points.back().value > points.front().value))
    return volume.range().lowest < volume.range().highest
               ? volume.range()
               : ValueRange{volume.range().lowest - 0.5, volume.range().lowest + 0.5};
  const double room = 0.06 * (points.back().value - points.front().value);
  return {points.front().value - room, points.back().value + room};
}

// That of a panel's curves together. Of a label's curve that is one value for all there is nothing to see.
ValueRange ownRange(const Figure& figure, const FigureLayout& layout, std::size_t panel) {
  const Scene& scene = figure.panels[panel].scene;
  ValueRange range = rangeOf(scene.transferFunction, *scene.volume);
  for (const LabelCurve& curve : layout.labels[panel].curves)
    if (curve.function.points.size() > 1) {
      const ValueRange its = rangeOf(curve.function, *scene.volume);
      range = {std::min(range.lowest, its.lowest), std::max(range.highest, its.highest)};
    }
  return range;
}

LegendParts partsOf(const QRectF& place, const ValueRange& range, const QFont& font) {
  const double text = font.pixelSize();
  const QFontMetricsF metrics(font);
  const double left = 2.0 * metrics.height() + metrics.horizontalAdvance(QStringLiteral("0.5"));
  const double ticks = 1.5 * text;
  const double bar = 0.8 * text;
  LegendParts parts;
  parts.text = text;
  parts.left = place.left();
  parts.line = std::max(1.0, text / 14.0);
  parts.bar = QRectF(place.left() + left, place.bottom() - ticks - bar, place.width() - left - text, bar);
  parts.transform.plot =
      QRectF(QPointF(parts.bar.left(), place.top() + 0.5 * text), QPointF(parts.bar.right(), parts.bar.top()))
          .adjusted(0.0, 0.0, 0.0, -0.25 * text);
  parts.transform.visible = range;
  return parts;
}

// One pixel row of the colours over the axis.
QImage colorsOver(const LegendParts& parts, const TransferFunction& function) {
  const int columns = std::max(1, static_cast<int>(std::ceil(parts.bar.width())));
  QImage row(columns, 1, QImage::Format_RGB32);
  for (int i = 0; i < columns; ++i) {
    const double x = parts.bar.left() + (i + 0.5) * parts.bar.width() / columns;
    row.setPixelColor(i, 0, toQColor(classify(function, valueAtX(parts.transform, x)).color));
  }
  return row;
}

void paintOpacities(QPainter& painter, const LegendParts& parts, const FigureColors& colors) {
  const QRectF& plot = parts.transform.plot;
  for (const double opacity : {0.0, 0.5, 1.0}) {
    const double y = yOfOpacity(parts.transform, opacity);
    painter.setPen(QPen(colors.grid, parts.line));
    painter.drawLine(QPointF(plot.left(), y), QPointF(plot.right(), y));
    painter.setPen(colors.quiet);
    painter.drawText(
        QRectF(plot.left() - 10.0 * parts.text, y - parts.text, 9.6 * parts.text, 2 * parts.text),
        Qt::AlignRight | Qt::AlignVCenter, plainNumber(opacity, 1));
  }
  painter.save();
  const double width = QFontMetricsF(painter.font()).horizontalAdvance(QStringLiteral("0.5"));
  painter.translate(plot.left() - width - 1.2 * parts.text, plot.center().y());
  painter.rotate(-90.0);
  painter.setPen(colors.quiet);
  painter.drawText(QRectF(-8.0 * parts.text, -parts.text, 16.0 * parts.text, 2.0 * parts.text),
                   Qt::AlignCenter, QObject::tr("Opacity"));
  painter.restore();
}

// The unit stands left of the numbers, where none has to give way to it; a long one at their right end.
void paintValues(QPainter& painter, const LegendParts& parts, const Scene& scene,
                 const FigureColors& colors) {
  const QString& told = QString::fromStdString(scene.volume->info().unit);
  const QString unit = told.isEmpty() ? QObject::tr("value") : told;
  const QFontMetricsF metrics(painter.font());
  const double gap = 0.6 * parts.text, unitWidth = metrics.horizontalAdvance(unit);
  const double top = parts.bar.bottom() + 0.3 * parts.text;
  const int most = std::max(2, static_cast<int>(parts.bar.width() / (6.0 * parts.text)));
  const std::vector<AxisTick> ticks = linearTicks(parts.transform.visible, most);
  const auto halfOf = [&metrics](const AxisTick& tick) { return metrics.horizontalAdvance(tick.text) / 2.0; };
  double first = parts.bar.left();
  if (!ticks.empty())
    first = std::min(first, xOfValue(parts.transform, ticks.front().value) - halfOf(ticks.front()));
  const bool isLeft = unitWidth <= first - gap - parts.left;
  const double end = isLeft ? parts.bar.right() + parts.text : parts.bar.right() - unitWidth - gap;
  for (const AxisTick& tick : ticks) {
    const double x = xOfValue(parts.transform, tick.value), half = halfOf(tick);
    painter.setPen(QPen(colors.line, parts.line));
    painter.drawLine(QPointF(x, parts.bar.bottom()), QPointF(x, parts.bar.bottom() + 0.25 * parts.text));
    if (!isLeft && x + half > end)
      continue;
    painter.setPen(colors.text);
    const double centre = std::min(x, end - half); // the last one may reach out of the legend
    painter.drawText(QRectF(centre - half - parts.text, top, 2.0 * (half + parts.text), 1.3 * parts.text),
                     Qt::AlignCenter, tick.text);
  }
  painter.setPen(colors.text);
  const double unitLeft = isLeft ? first - gap - unitWidth : parts.bar.right() - unitWidth;
  painter.drawText(QRectF(unitLeft - parts.text, top, unitWidth + 2.0 * parts.text, 1.3 * parts.text),
                   Qt::AlignCenter, unit);
}

void paintOpacityCurve(QPainter& painter, const LegendParts& parts, const TransferFunction& function,
                       const FigureColors& colors, const QImage& row) {
  const QPolygonF line = curvePolygon(parts.transform, function);
  if (line.isEmpty())
    return;
  const QRectF& plot = parts.transform.plot;
  QPolygonF area = line;
  area << plot.bottomRight() << plot.bottomLeft();
  QBrush under(row);
  under.setTransform(QTransform::fromTranslate(plot.left(), 0.0).scale(parts.bar.width() / row.width(), 1.0));
  painter.setPen(Qt::NoPen);
  painter.setBrush(under);
  painter.setOpacity(0.45);
  painter.drawPolygon(area);
  painter.setOpacity(1.0);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.text, 1.6 * parts.line, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
  painter.drawPolyline(line);
}

// In its colour, with an edge that stands out from the page.
void paintLabelCurve(QPainter& painter, const LegendParts& parts, const LabelCurve& curve,
                     const FigureColors& colors) {
  const QPolygonF line = curvePolygon(parts.transform, curve.function);
  painter.setBrush(Qt::NoBrush);
  for (const auto& [color, width] : {std::pair(colors.line, 3.6), std::pair(curve.color, 2.0)}) {
    painter.setPen(QPen(color, width * parts.line, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
    painter.drawPolyline(line);
  }
}

// A picture of a surface hangs on one value.
void paintIsovalue(QPainter& painter, const LegendParts& parts, const Scene& scene,
                   const FigureColors& colors) {
  if (scene.projection != Projection::isosurface && scene.projection != Projection::compositeIsosurface)
    return;
  const double x = xOfValue(parts.transform, scene.isovalue);
  const QRectF& plot = parts.transform.plot;
  if (x < plot.left() || x > plot.right())
    return;
  painter.setPen(QPen(colors.text, parts.line, Qt::DashLine));
  painter.drawLine(QPointF(x, plot.top()), QPointF(x, parts.bar.bottom()));
}

// Where a picture is still to come.
const QColor awaitedColor(128, 128, 128, 60);

// The letter is bold, what follows the name steps back.
void paintHeading(QPainter& painter, const Figure& figure, const FigureLayout& layout, std::size_t panel) {
  const FigureColors colors = colorsOn(figure.settings.page);
  const QRectF& place = layout.headings[panel];
  for (const HeadingPart& part : headingParts(figure, panel, layout, place.width())) {
    painter.setFont(headingFont(layout, part.kind));
    painter.setPen(part.kind == HeadingPart::Kind::details ? colors.quiet : colors.text);
    painter.drawText(place.topLeft() + QPointF(part.left, headingBaseline(layout, part.line)), part.text);
  }
}

void paintNotes(QPainter& painter, const Figure& figure, const FigureLayout& layout) {
  painter.setFont(figureFont(layout, noteScale));
  painter.setPen(colorsOn(figure.settings.page).quiet);
  painter.drawText(layout.notes, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                   notesOf(figure, layout.labels));
}

// Paints opacity over value, the colours below it, and an axis in the volume's unit; over the scene's curve
// those of labels.
void paintLegend(QPainter& painter, const QRectF& place, const Scene& scene,
                 const std::vector<LabelCurve>& ofLabels, const ValueRange& range, const QFont& font,
                 const FigureColors& colors) {
  const LegendParts parts = partsOf(place, range, font);
  if (parts.bar.width() < 4.0 * parts.text)
    return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(font);
  paintOpacities(painter, parts, colors);
  const QImage row = colorsOver(parts, scene.transferFunction);
  paintOpacityCurve(painter, parts, scene.transferFunction, colors, row);
  for (const LabelCurve& curve : ofLabels)
    paintLabelCurve(painter, parts, curve, colors);
  painter.drawImage(parts.bar, row);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.line, parts.line));
  painter.drawRect(parts.bar);
  paintValues(painter, parts, scene, colors);
  paintIsovalue(painter, parts, scene, colors);
  painter.restore();
}

// White with a dark edge, so that they stand out from any picture.
void paintPictureMarks(QPainter& painter, const PictureMarks& marks, const FigureLayout& layout) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(figureFont(layout));
  const double halo = haloOf(layout);
  for (const EdgeLetter& letter : marks.letters)
    paintOutlined(painter, letter.place, letter.text, halo);
  if (marks.scale) {
    const double edge = halo / 2.0;
    painter.fillRect(marks.scale->bar.adjusted(-edge, -edge, edge, edge), haloColor);
    painter.fillRect(marks.scale->bar, Qt::white);
    paintOutlined(painter, marks.scale->textPlace, marks.scale->text, halo);
  }
  if (marks.measures)
    paintFigureMeasures(painter, *marks.measures);
  painter.restore();
}

} // namespace

ValueRange legendRange(const Figure& figure, const FigureLayout& layout, std::size_t panel) {
  const std::string& unit = figure.panels[panel].scene.volume->info().unit;
  ValueRange range = ownRange(figure, layout, panel);
  for (const LegendPlace& legend : layout.legends)
    if (figure.panels[legend.panel].scene.volume->info().unit == unit) {
      const ValueRange its = ownRange(figure, layout, legend.panel);
      range = {std::min(range.lowest, its.lowest), std::max(range.highest, its.highest)};
    }
  return range;
}

PictureMarks pictureMarks(const Figure& figure, const FigureLayout& layout, std::size_t panel) {
  const QRectF picture(layout.pictures[panel]);
  PictureMarks marks;
  if (figure.settings.shows(FigureMark::orientation))
    if (const auto letters = lettersOfPanel(figure.panels[panel]))
      marks.letters = edgeLetters(*letters, picture, layout);
  if (figure.settings.shows(FigureMark::scaleBar))
    marks.scale = scaleBarOn(figure.panels[panel], picture, layout);
  if (figure.settings.shows(FigureMark::measurements) && !figure.panels[panel].measurements.empty())
    marks.measures = figureMeasures(figure.panels[panel], layout, picture, coveredBy(marks, layout));
  return marks;
}

std::vector<QRectF> coveredBy(const PictureMarks& marks, const FigureLayout& layout) {
  const double reach = haloOf(layout) + 1.0;
  std::vector<QRectF> covered;
  for (const EdgeLetter& letter : marks.letters)
    covered.push_back(letter.place.adjusted(-reach, -reach, reach, reach));
  if (marks.scale) {
    covered.push_back(marks.scale->textPlace.adjusted(-reach, -reach, reach, reach));
    covered.push_back(marks.scale->bar.adjusted(-reach, -reach, reach, reach));
  }
  if (marks.measures)
    for (const QRectF& part : coveredBy(*marks.measures))
      covered.push_back(part.adjusted(-1.0, -1.0, 1.0, 1.0));
  return covered;
}

void paintPage(QPainter& painter, const Figure& figure, const FigureLayout& layout) {
  if (figure.settings.page == FigureSettings::Page::transparent)
    return;
  QRegion page(QRect(QPoint(0, 0), layout.size));
  for (const QRect& picture : layout.pictures)
    page -= picture;
  for (const QRect& part : page)
    painter.fillRect(part, colorsOn(figure.settings.page).page);
}

void paintMarks(QPainter& painter, const Figure& figure, const FigureLayout& layout) {
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    if (!layout.headings.empty())
      paintHeading(painter, figure, layout, i);
    paintPictureMarks(painter, pictureMarks(figure, layout, i), layout);
  }
  for (const LegendPlace& legend : layout.legends)
    paintLegend(painter, legend.place, figure.panels[legend.panel].scene, layout.labels[legend.panel].curves,
                legendRange(figure, layout, legend.panel), figureFont(layout, noteScale),
                colorsOn(figure.settings.page));
  for (const LegendPlace& labels : layout.labelLegends) {
    const FigureColors colors = colorsOn(figure.settings.page);
    paintLabelRows(painter, labels.place, layout.labels[labels.panel].rows, layout, colors.text, colors.line);
  }
  if (!layout.notes.isEmpty())
    paintNotes(painter, figure, layout);
}

void paintFigure(QPainter& painter, const Figure& figure, const FigureLayout& layout,
                 const std::vector<QImage>& pictures) {
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::LosslessImageRendering);
  paintPage(painter, figure, layout);
  for (std::size_t i = 0; i < layout.pictures.size(); ++i)
    if (i < pictures.size() && !pictures[i].isNull())
      painter.drawImage(layout.pictures[i], pictures[i]);
    else
      painter.fillRect(layout.pictures[i], awaitedColor);
  paintMarks(painter, figure, layout);
}

QImage figureImage(const Figure& figure, const FigureLayout& layout, const std::vector<QImage>& pictures) {
  const bool isOpaque = figure.settings.page != FigureSettings::Page::transparent;
  QImage image(layout.size, isOpaque ? QImage::Format_RGB32 : QImage::Format_ARGB32_Premultiplied);
  if (image.isNull())
    throw std::bad_alloc();
  image.fill(isOpaque ? Qt::black : Qt::transparent);
  QPainter painter(&image);
  paintFigure(painter, figure, layout, pictures);
  return image;
}

} // namespace limn
