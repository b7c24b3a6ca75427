// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/figure/PictureMarks.h"

#include "widgets/ValueText.h"

#include <QFontMetricsF>
#include <QObject>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

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

} // namespace

PictureMarks pictureMarks(const Figure& figure, const FigureLayout& layout, std::size_t panel) {
  const QRectF picture(layout.pictures[panel]);
  PictureMarks marks;
  if (figure.settings.shows(FigureMark::orientation))
    if (const auto letters = lettersOfPanel(figure.panels[panel]))
      marks.letters = edgeLetters(*letters, picture, layout);
  if (figure.settings.shows(FigureMark::scaleBar))
    marks.scale = scaleBarOn(figure.panels[panel], picture, layout);
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
  return covered;
}

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
  painter.restore();
}

} // namespace limn
