// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/theme/Theme.h"
#include "widgets/ContrastRatio.h"
#include "widgets/WidgetSamples.h"
#include "widgets/curve/picture/CanvasPicture.h"
#include "widgets/theme/Icons.h"
#include "widgets/theme/LookStyle.h"

#include <QApplication>
#include <QImage>
#include <QStyleFactory>

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

TEST(Contrast, isThatOfTheStandard) {
  EXPECT_NEAR(contrastRatio(Qt::black, Qt::white), 21.0, 1e-9); // WCAG 2.1: the largest possible
  EXPECT_NEAR(contrastRatio(Qt::red, Qt::red), 1.0, 1e-9);
  // #767676 on white is the standard's well-known lightest grey with 4.5:1 (4.54).
  EXPECT_NEAR(contrastRatio(QColor("#767676"), Qt::white), 4.54, 0.005);
}

TEST(LookStyle, givesDialogsIconsOfOurOwnAndTheirButtonsNone) {
  const LookStyle look;
  const std::unique_ptr<QStyle> fusion(QStyleFactory::create(QStringLiteral("Fusion")));
  EXPECT_EQ(look.styleHint(QStyle::SH_DialogButtonBox_ButtonsHaveIcons, nullptr, nullptr, nullptr), 0);
  const auto drawn = [](const QStyle& style, QStyle::StandardPixmap icon) {
    return style.standardIcon(icon, nullptr, nullptr).pixmap(24).toImage();
  };
  for (const auto icon :
       {QStyle::SP_DirIcon, QStyle::SP_FileIcon, QStyle::SP_ComputerIcon, QStyle::SP_DirHomeIcon,
        QStyle::SP_ArrowBack, QStyle::SP_ArrowForward, QStyle::SP_FileDialogToParent,
        QStyle::SP_FileDialogNewFolder, QStyle::SP_FileDialogListView, QStyle::SP_FileDialogDetailedView,
        QStyle::SP_LineEditClearButton, QStyle::SP_MessageBoxQuestion, QStyle::SP_MessageBoxInformation,
        QStyle::SP_MessageBoxWarning, QStyle::SP_MessageBoxCritical}) {
    EXPECT_FALSE(drawn(look, icon).isNull()) << icon;
    EXPECT_NE(drawn(look, icon), drawn(*fusion, icon)) << icon;
  }
}

class LookTest : public testing::TestWithParam<Look> {};

TEST_P(LookTest, textContrastIsAtLeastFourAndAHalf) {
  const ThemeColors c = themeColors(GetParam());
  for (const QColor& background : {c.window, c.base, c.raised, c.hover}) {
    EXPECT_GE(contrastRatio(c.text, background), 7.0) << background.name().toStdString();
    EXPECT_GE(contrastRatio(c.secondaryText, background), 4.5) << background.name().toStdString();
  }
  for (const QColor& background : {c.window, c.base}) // a label that is out of use still says something
    EXPECT_GE(contrastRatio(c.disabledText, background), 4.5) << background.name().toStdString();
  EXPECT_GE(contrastRatio(c.accentText, c.accent), 4.5);
  // Tool tips are inverted: base on text.
  EXPECT_GE(contrastRatio(c.base, c.text), 7.0);
}

TEST_P(LookTest, whatIsNoTextStandsOutByThreeToOne) {
  const ThemeColors c = themeColors(GetParam());
  for (const QColor& background : {c.window, c.base, c.raised}) {
    EXPECT_GE(contrastRatio(c.accent, background), 3.0) << background.name().toStdString();
    EXPECT_GE(contrastRatio(c.curve, background), 3.0) << background.name().toStdString();
    EXPECT_GE(contrastRatio(c.outline, background), 3.0) << background.name().toStdString();
  }
  // What lies over the histogram stands out from its area.
  EXPECT_GE(contrastRatio(c.curve, c.histogram), 4.5);
  EXPECT_GE(contrastRatio(c.accent, c.histogram), 3.0);
  EXPECT_GE(contrastRatio(c.secondaryText, c.histogram), 3.0);
}

// The histogram's shape is told by its edge, which lies over the colours of the curve.
TEST_P(LookTest, theHistogramStandsOutFromThePlotUnderAnyColour) {
  const ThemeColors c = themeColors(GetParam());
  EXPECT_GE(contrastRatio(c.histogramEdge, c.base), 3.0);
  for (int corner = 0; corner < 8; ++corner) { // contrast is least at a corner of the cube of colours
    const auto over = [&](double ground, int bit) {
      return std::lerp(ground, corner >> bit & 1 ? 1.0 : 0.0, colorsOpacity);
    };
    const QColor colored = QColor::fromRgbF(static_cast<float>(over(c.base.redF(), 0)),
                                            static_cast<float>(over(c.base.greenF(), 1)),
                                            static_cast<float>(over(c.base.blueF(), 2)));
    EXPECT_GE(contrastRatio(c.histogramEdge, colored), 3.0) << colored.name().toStdString();
    EXPECT_GE(contrastRatio(c.curve, colored), 3.0) << colored.name().toStdString();
  }
}

TEST_P(LookTest, thePaletteIsRecognisedAsItsLook) {
  EXPECT_EQ(lookOf(themePalette(GetParam())), GetParam());
  EXPECT_EQ(isDark(themePalette(GetParam())), GetParam() != Look::light);
  EXPECT_EQ(themeColors(themePalette(GetParam())).window, themeColors(GetParam()).window);
}

TEST_P(LookTest, theStyleSheetHasNoNameLeft) {
  const QString sheet = themeStyleSheet(GetParam());
  EXPECT_GT(sheet.size(), 1000);
  EXPECT_FALSE(sheet.section(QStringLiteral("*/"), 2).contains(QLatin1Char('@')));
}

INSTANTIATE_TEST_SUITE_P(Theme, LookTest, testing::Values(Look::light, Look::dark, Look::contrast));

TEST(Contrast, ofTheLookForItIsSevenToOneAndLinesAreSeen) {
  const ThemeColors c = themeColors(Look::contrast);
  for (const QColor& background : {c.window, c.base, c.raised, c.hover}) {
    for (const QColor& text : {c.text, c.secondaryText, c.disabledText, c.accent})
      EXPECT_GE(contrastRatio(text, background), 7.0) << text.name().toStdString();
    EXPECT_GE(contrastRatio(c.border, background), 4.5) << background.name().toStdString();
  }
}

TEST(Icons, areSharpAndFollowTheLook) {
  for (const char* name :
       {"open", "undo", "redo", "single", "side-by-side", "wipe", "difference", "compass", "snapshot",
        "preset-save", "delete", "search", "show-all", "fold", "unfold", "crop-box"})
    EXPECT_TRUE(iconNames().contains(QLatin1String(name))) << name;
  for (const QString& name : iconNames())
    for (const Look look : {Look::light, Look::dark, Look::contrast}) {
      const QImage image = themedIcon(name, themePalette(look)).pixmap(QSize(24, 24)).toImage();
      const QColor text = themeColors(look).text;
      int strongest = 0;
      QColor drawn;
      for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
          if (image.pixelColor(x, y).alpha() > strongest) {
            strongest = image.pixelColor(x, y).alpha();
            drawn = image.pixelColor(x, y);
          }
      EXPECT_GT(strongest, 150) << name.toStdString();
      // Un-premultiplying 8 bits costs up to one level at this alpha.
      EXPECT_NEAR(drawn.red(), text.red(), 2) << name.toStdString();
    }
}

} // namespace
} // namespace limn
