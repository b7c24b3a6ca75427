// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/figure/FigureHeading.h"

#include "scene/volume/Phantom.h"
#include "widgets/figure/FigurePainting.h"
#include "widgets/figure/FigureText.h"

#include <QFontMetricsF>
#include <QImage>

#include <gtest/gtest.h>

#include <algorithm>

// What stands above the pictures of a figure, which is never cut.

namespace limn {
namespace {

// As of two presets that are compared.
const QString longName = QStringLiteral("CT skin, modified · Enhanced, normals smoothed by hand");

Figure figureOf(std::size_t panels, const QString& name) {
  static const std::shared_ptr<const Volume> volume = phantomVolume({16.0});
  Figure figure;
  for (std::size_t i = 0; i < panels; ++i) {
    FigurePanel panel;
    panel.scene.volume = volume;
    panel.scene.camera = defaultCamera(volume->grid());
    panel.scene.transferFunction.points = {{0.0, {1.0, 0.0, 0.0}, 0.0}, {1000.0, {1.0, 1.0, 1.0}, 1.0}};
    panel.name = i == 0 ? QStringLiteral("CT bone") : name;
    figure.panels.push_back(panel);
  }
  return figure;
}

QString wordsOf(const std::vector<HeadingPart>& parts, HeadingPart::Kind kind) {
  QString words;
  for (const HeadingPart& part : parts)
    if (part.kind == kind)
      words += part.text;
  return words.remove(QLatin1Char(' ')).remove(QChar(0xa0));
}

QString packed(QString text) {
  return text.remove(QLatin1Char(' '));
}

int linesOf(const std::vector<HeadingPart>& parts) {
  return parts.back().line + 1;
}

TEST(FigureHeading, longNamesGoOnBelowAndNothingIsCut) {
  for (const QString& name : {longName, QString(60, QLatin1Char('n')), QString()})
    for (std::size_t count = 2; count <= mostPanels; ++count) {
      const Figure figure = figureOf(count, name);
      const FigureLayout layout = figureLayout(figure);
      for (std::size_t panel = 0; panel < count; ++panel) {
        const QRectF& place = layout.headings[panel];
        const auto parts = headingParts(figure, panel, layout, place.width());
        EXPECT_EQ(wordsOf(parts, HeadingPart::Kind::letter), panelLetter(panel));
        EXPECT_EQ(wordsOf(parts, HeadingPart::Kind::name), packed(figure.panels[panel].name));
        EXPECT_EQ(wordsOf(parts, HeadingPart::Kind::details), packed(panelDetails(figure.panels[panel])));
        for (const HeadingPart& part : parts) {
          const QFontMetricsF metrics(headingFont(layout, part.kind));
          EXPECT_LE(part.left + metrics.horizontalAdvance(part.text), place.width() + 1.0)
              << count << " panels: " << part.text.toStdString();
          EXPECT_FALSE(part.text.startsWith(QChar(0xb7))) << part.text.toStdString();
          EXPECT_LE(headingBaseline(layout, part.line) + metrics.descent(), place.height())
              << count << " panels: " << part.text.toStdString();
        }
      }
    }
}

TEST(FigureHeading, shortNamesStayOnOneLine) {
  const Figure figure = figureOf(2, QStringLiteral("CT skin"));
  const FigureLayout layout = figureLayout(figure);
  EXPECT_EQ(layout.headings[0].height(), std::round(1.7 * layout.textPixels));
  for (std::size_t panel = 0; panel < 2; ++panel)
    EXPECT_EQ(linesOf(headingParts(figure, panel, layout, layout.headings[panel].width())), 1);
}

// Pictures stay below each other and beside each other, and keep their size where no height is asked for.
TEST(FigureHeading, allPanelsGetTheRoomOfTheLongest) {
  const FigureLayout shorter = figureLayout(figureOf(4, QStringLiteral("CT skin")));
  const FigureLayout longer = figureLayout(figureOf(4, longName));
  EXPECT_GT(longer.headings[0].height(), shorter.headings[0].height());
  EXPECT_EQ(longer.headings[0].height(), longer.headings[3].height());
  EXPECT_EQ(longer.pictureSize(), shorter.pictureSize());
  EXPECT_GT(longer.size.height(), shorter.size.height());
}

// Below the first line of the second panel stand its other ones; beside them, of the first, is nothing.
TEST(FigureHeading, isPaintedWhole) {
  const Figure figure = figureOf(2, longName);
  const FigureLayout layout = figureLayout(figure);
  const QImage drawn = figureImage(figure, layout, {});
  const auto inked = [&](std::size_t panel, int line) {
    const QRectF& place = layout.headings[panel];
    const double base = place.top() + headingBaseline(layout, line);
    const QRect band =
        QRectF(place.left(), base - 0.5 * layout.textPixels, place.width(), 0.5 * layout.textPixels).toRect();
    int dark = 0;
    for (int y = band.top(); y <= band.bottom(); ++y)
      for (int x = band.left(); x <= band.right(); ++x)
        dark += qGray(drawn.pixel(x, y)) < 160 ? 1 : 0;
    return dark;
  };
  const int last = linesOf(headingParts(figure, 1, layout, layout.headings[1].width())) - 1;
  ASSERT_GE(last, 1);
  EXPECT_GT(inked(1, last), 20);
  EXPECT_EQ(inked(0, last), 0);
}

} // namespace
} // namespace limn
