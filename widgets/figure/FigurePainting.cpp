// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/figure/FigurePainting.h"

#include "widgets/figure/FigureColors.h"
#include "widgets/figure/FigureText.h"
#include "widgets/figure/LegendPainting.h"
#include "widgets/figure/PictureMarks.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QRegion>

#include <new>

namespace limn {
namespace {

// Where a picture is still to come.
const QColor awaitedColor(128, 128, 128, 60);

// "a  Enhanced  SP 1–64 · O 0–3": the letter is bold, what follows the name steps back.
void paintHeading(QPainter& painter, const Figure& figure, const FigureLayout& layout, std::size_t panel) {
  const FigureColors colors = colorsOn(figure.settings.page);
  const QRectF& place = layout.headings[panel];
  double x = place.left();
  const auto paint = [&](const QString& text, const QFont& font, const QColor& color, double gap) {
    const QFontMetricsF metrics(font);
    const QString fitting = metrics.elidedText(text, Qt::ElideRight, place.right() - x);
    painter.setFont(font);
    painter.setPen(color);
    painter.drawText(QPointF(x, place.top() + QFontMetricsF(figureFont(layout)).ascent()), fitting);
    x += metrics.horizontalAdvance(fitting) + gap * layout.textPixels;
  };
  if (figure.settings.shows(FigureMark::panelLetters) && figure.panels.size() > 1) {
    QFont bold = figureFont(layout, 1.1);
    bold.setBold(true);
    paint(panelLetter(panel), bold, colors.text, 0.6);
  }
  if (!figure.settings.shows(FigureMark::names))
    return;
  const FigurePanel& shown = figure.panels[panel];
  if (!shown.name.isEmpty())
    paint(shown.name, figureFont(layout), colors.text, 0.8);
  const QString details = panelDetails(shown);
  if (x < place.right() - 4.0 * layout.textPixels && !details.isEmpty())
    paint(details, figureFont(layout, noteScale), colors.quiet, 0.0);
}

void paintNotes(QPainter& painter, const Figure& figure, const FigureLayout& layout) {
  painter.setFont(figureFont(layout, noteScale));
  painter.setPen(colorsOn(figure.settings.page).quiet);
  painter.drawText(layout.notes, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, notesOf(figure));
}

} // namespace

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
    paintLegend(painter, legend.place, figure.panels[legend.panel].scene, figureFont(layout, noteScale),
                colorsOn(figure.settings.page));
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
