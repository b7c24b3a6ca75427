// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/figure/FigureLayout.h"

#include "scene/basics/Error.h"
#include "widgets/figure/FigureHeading.h"
#include "widgets/figure/FigureText.h"
#include "widgets/figure/LabelLegend.h"

#include <QFontMetricsF>
#include <QObject>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <utility>

namespace limn {
namespace {

// In heights of the body's font.
constexpr double pageMargin = 0.8;
constexpr double panelGap = 1.2;
constexpr double legendHeight = 7.6;
constexpr double legendGap = 0.9;
constexpr double notesGap = 0.7;

// Smaller pictures are no pictures.
constexpr int leastPictureSide = 16;
// Text may take no more than this share of a panel's width: a small figure gets small text.
constexpr double mostTextOfPanel = 1.0 / 20.0;

/// What a figure has above, between and below its pictures, pixels.
struct Furniture {
  int columns = 1, rows = 1;
  double margin = 0.0, gap = 0.0, heading = 0.0;
  double ownLegend = 0.0, sharedLegend = 0.0;
  double ownLabels = 0.0, sharedLabels = 0.0;
  double notes = 0.0;

  double besidePictures() const { return 2.0 * margin + (columns - 1) * gap; }
  double cellFurniture() const { return heading + ownLegend + ownLabels; }
  /// Of one picture, whole pixels.
  int pictureWidth(const FigureLayout& layout) const {
    return static_cast<int>((layout.size.width() - besidePictures()) / columns);
  }
  double abovePictures() const {
    return 2.0 * margin + (rows - 1) * gap + rows * cellFurniture() + sharedLegend + sharedLabels + notes;
  }
};

int pixelsOf(const FigureSettings& settings, double length, const QString& side) {
  const double pixels = std::round(toPixels(settings, length));
  if (!(pixels >= fewestFigurePixels) || pixels > mostFigurePixels)
    throw Error(
        Error::Kind::usage,
        QObject::tr("The figure would be %1 pixels %2; from %3 to %4 are possible: choose another size "
                    "or fewer dots per inch.")
            .arg(pixels, 0, 'f', 0)
            .arg(side)
            .arg(fewestFigurePixels)
            .arg(mostFigurePixels)
            .toStdString());
  return static_cast<int>(pixels);
}

// Panels whose curve is explained, if it is.
std::vector<std::size_t> panelsWithCurve(const Figure& figure) {
  std::vector<std::size_t> panels;
  if (figure.settings.shows(FigureMark::curve))
    for (std::size_t i = 0; i < figure.panels.size(); ++i)
      if (hasCurve(figure.panels[i]))
        panels.push_back(i);
  return panels;
}

bool shareCurve(const Figure& figure, const FigureLabels& labels, const std::vector<std::size_t>& panels) {
  const Scene& first = figure.panels[panels.front()].scene;
  return std::ranges::all_of(panels, [&](std::size_t panel) {
    const Scene& scene = figure.panels[panel].scene;
    return scene.transferFunction == first.transferFunction &&
           scene.volume->info().unit == first.volume->info().unit && scene.projection == first.projection &&
           scene.isovalue == first.isovalue && labels[panel].curves == labels[panels.front()].curves;
  });
}

// Told once where all that have some have the same.
void addLabels(Furniture& furniture, const FigureLayout& layout) {
  const double cell = (layout.size.width() - furniture.besidePictures()) / furniture.columns;
  const double gap = std::round(legendGap * layout.textPixels);
  std::vector<std::vector<LabelRow>> all;
  for (const PanelLabels& labels : layout.labels)
    if (!labels.rows.empty())
      all.push_back(labels.rows);
  if (all.empty())
    return;
  const bool isShared = std::ranges::all_of(all, [&](const auto& rows) { return rows == all.front(); });
  const double width = isShared ? layout.size.width() - 2.0 * furniture.margin : cell;
  double height = 0.0;
  for (const std::vector<LabelRow>& rows : all)
    height = std::max(height, labelColumns(rows, width, layout.textPixels).height);
  (isShared ? furniture.sharedLabels : furniture.ownLabels) = height + gap;
}

double heightOfNotes(const Figure& figure, const FigureLayout& layout, double width) {
  const QString notes = notesOf(figure, layout.labels);
  if (notes.isEmpty())
    return 0.0;
  const QFontMetricsF metrics(figureFont(layout, noteScale));
  return std::ceil(
      metrics.boundingRect(QRectF(0.0, 0.0, width, 1e6), Qt::AlignLeft | Qt::TextWordWrap, notes).height());
}

Furniture furnitureOf(const Figure& figure, const FigureLayout& layout) {
  const double text = layout.textPixels;
  const auto count = static_cast<int>(figure.panels.size());
  Furniture furniture;
  furniture.columns = count == 4 ? 2 : count;
  furniture.rows = count == 4 ? 2 : 1;
  furniture.margin = std::round(pageMargin * text);
  furniture.gap = std::round(panelGap * text);
  const FigureSettings& settings = figure.settings;
  if (settings.shows(FigureMark::panelLetters) || settings.shows(FigureMark::names))
    furniture.heading = headingHeight(figure, layout, furniture.pictureWidth(layout));
  const std::vector<std::size_t> curves = panelsWithCurve(figure);
  const double legend = std::round((legendGap + legendHeight) * text);
  if (!curves.empty())
    (shareCurve(figure, layout.labels, curves) ? furniture.sharedLegend : furniture.ownLegend) = legend;
  addLabels(furniture, layout);
  const double notes = heightOfNotes(figure, layout, layout.size.width() - 2.0 * furniture.margin);
  if (notes > 0.0)
    furniture.notes = notes + std::round(notesGap * text);
  return furniture;
}

void placeLegends(FigureLayout& layout, const Figure& figure, const Furniture& furniture, double top) {
  const double gap = std::round(legendGap * layout.textPixels);
  const double margin = furniture.margin;
  const std::vector<std::size_t> curves = panelsWithCurve(figure);
  if (furniture.sharedLegend > 0.0)
    layout.legends.push_back(
        {QRectF(margin, top + gap, layout.size.width() - 2.0 * margin, furniture.sharedLegend - gap),
         curves.front()});
  if (furniture.ownLegend > 0.0)
    for (const std::size_t panel : curves) {
      const QRect& picture = layout.pictures[panel];
      layout.legends.push_back(
          {QRectF(picture.left(), picture.bottom() + 1.0 + gap, picture.width(), furniture.ownLegend - gap),
           panel});
    }
}

void placeLabels(FigureLayout& layout, const Furniture& furniture, double top) {
  const double gap = std::round(legendGap * layout.textPixels);
  for (std::size_t panel = 0; panel < layout.labels.size(); ++panel) {
    if (layout.labels[panel].rows.empty())
      continue;
    if (furniture.sharedLabels > 0.0) {
      layout.labelLegends.push_back(
          {QRectF(furniture.margin, top + gap, layout.size.width() - 2.0 * furniture.margin,
                  furniture.sharedLabels - gap),
           panel});
      return;
    }
    const QRect& picture = layout.pictures[panel];
    layout.labelLegends.push_back({QRectF(picture.left(), picture.bottom() + 1.0 + furniture.ownLegend + gap,
                                          picture.width(), furniture.ownLabels - gap),
                                   panel});
  }
}

void placePictures(FigureLayout& layout, const Figure& figure, const Furniture& furniture,
                   const QSize& picture) {
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const auto column = static_cast<int>(i) % furniture.columns;
    const auto row = static_cast<int>(i) / furniture.columns;
    const double x = furniture.margin + column * (picture.width() + furniture.gap);
    const double y = furniture.margin + row * (picture.height() + furniture.cellFurniture() + furniture.gap);
    if (furniture.heading > 0.0)
      layout.headings.emplace_back(x, y, picture.width(), furniture.heading);
    layout.pictures.emplace_back(QPoint(static_cast<int>(x), static_cast<int>(y + furniture.heading)),
                                 picture);
  }
}

} // namespace

QFont figureFont(const FigureLayout& layout, double scale) {
  QFont font;
  font.setFamilies({QStringLiteral("Arial"), QStringLiteral("Helvetica"), QStringLiteral("Liberation Sans"),
                    QStringLiteral("DejaVu Sans")});
  font.setStyleHint(QFont::SansSerif);
  // Without hinting, text is as wide in any number of pixels.
  font.setHintingPreference(QFont::PreferNoHinting);
  font.setPixelSize(std::max(1, static_cast<int>(std::lround(scale * layout.textPixels))));
  return font;
}

FigureLayout figureLayout(const Figure& figure) {
  return figureLayout(figure, figureLabels(figure));
}

FigureLayout figureLayout(const Figure& figure, FigureLabels labels) {
  const FigureSettings& settings = figure.settings;
  FigureLayout layout;
  layout.labels = std::move(labels);
  layout.size.setWidth(pixelsOf(settings, settings.width, QObject::tr("wide")));
  const auto count = static_cast<int>(figure.panels.size());
  const int columns = count == 4 ? 2 : count;
  layout.textPixels = std::min(settings.textPoints * settings.dotsPerInch / 72.0,
                               mostTextOfPanel * layout.size.width() / columns);
  const Furniture furniture = furnitureOf(figure, layout);
  const int width = furniture.pictureWidth(layout);
  int height = static_cast<int>(std::lround(width / settings.panelAspect));
  if (settings.height) {
    layout.size.setHeight(pixelsOf(settings, *settings.height, QObject::tr("high")));
    height = static_cast<int>((layout.size.height() - furniture.abovePictures()) / furniture.rows);
  }
  if (width < leastPictureSide || height < leastPictureSide)
    throw Error(
        Error::Kind::usage,
        QObject::tr("What stands around the pictures leaves no room for them; choose a larger figure, "
                    "smaller text or fewer marks.")
            .toStdString());
  if (!settings.height) {
    const double needed = std::ceil(furniture.rows * height + furniture.abovePictures());
    FigureSettings inPixels = settings;
    inPixels.unit = FigureSettings::Unit::pixels;
    layout.size.setHeight(pixelsOf(inPixels, needed, QObject::tr("high")));
  }
  placePictures(layout, figure, furniture, {width, height});
  const double bottom = layout.size.height() - furniture.margin - furniture.notes - furniture.sharedLabels;
  placeLegends(layout, figure, furniture, bottom - furniture.sharedLegend);
  placeLabels(layout, furniture, bottom);
  if (furniture.notes > 0.0)
    layout.notes = QRectF(furniture.margin, layout.size.height() - furniture.margin - furniture.notes,
                          layout.size.width() - 2.0 * furniture.margin, furniture.notes)
                       .adjusted(0.0, std::round(notesGap * layout.textPixels), 0.0, 0.0);
  return layout;
}

} // namespace limn
