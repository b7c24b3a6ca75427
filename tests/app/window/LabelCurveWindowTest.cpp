// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/LabelledBoxes.h"
#include "scene/LabelLooks.h"
#include "scene/framing/KeptVoxels.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/properties/LabelSection.h"
#include "widgets/theme/LookStyle.h"
#include "widgets/theme/Theme.h"

#include <QComboBox>
#include <QTreeView>

#include <array>
#include <fstream>
#include <numeric>

// Labels with curves of their own, in the program's window.

namespace limn {
namespace {

class LabelCurveWindow : public test::LabelledBoxes {
protected:
  void SetUp() override {
    LabelledBoxes::SetUp(); // each of which is a label
    write("two.seg.nrrd", [](const glm::ivec3& v) { return !isInBoxes(v) ? 0 : v.x < 16 ? 3 : 8; });
    ASSERT_TRUE(openAlone(pathTo("two.nrrd")));
    ASSERT_TRUE(openLabels("two.seg.nrrd"));
    function = scene().transferFunction;
  }

  LabelSection& section() { return *window->findChild<LabelSection*>(); }
  QTreeView& table() { return *section().findChild<QTreeView*>(); }
  TransferFunctionCanvas& canvas() { return *curves().valueEditor()->canvas(); }
  QComboBox& whose() {
    for (QComboBox* box : curves().findChildren<QComboBox*>())
      if (box->accessibleName() == QStringLiteral("Whose curve"))
        return *box;
    ADD_FAILURE() << "no such box";
    return *curves().findChild<QComboBox*>();
  }
  const TransferFunction& curveOf(std::size_t place) {
    const std::size_t look = lookOfLabel(scene().keep, place);
    return look > 0 ? scene().keep.looks[look - 1] : scene().transferFunction;
  }
  // A click on the mark in the third column.
  void toggleCurve(int row) {
    section().setFolded(false);
    table().setFocus();
    table().setCurrentIndex(table().model()->index(row, LabelTable::curveColumn));
    QTest::keyClick(&table(), Qt::Key_Space);
    QCoreApplication::processEvents();
  }
  static TransferFunction red() {
    return {1.0, {{200.0, {1.0, 0.0, 0.0}, 0.0}, {300.0, {1.0, 0.0, 0.0}, 0.9}}};
  }
  // The mean red and blue of what is drawn left and right of the middle.
  std::array<double, 2> rednessOfSides() {
    const QImage picture = view().grab().toImage();
    const QRectF place = view().logicalRect(0);
    const double scale = view().devicePixelRatioF();
    std::array<double, 2> redness{};
    for (int side = 0; side < 2; ++side)
      for (int n = -6; n <= 6; ++n) {
        const QPointF at = (place.center() + QPointF((side == 0 ? -0.2 : 0.2) * place.height(), n)) * scale;
        const QColor color = picture.pixelColor(at.toPoint());
        redness[static_cast<std::size_t>(side)] += (color.red() - color.blue()) / 13.0;
      }
    return redness;
  }

  TransferFunction function;
};

// A row is selected with and without the keyboard.
TEST_F(LabelCurveWindow, aLineAroundTheLabelsShowsThatTheyHaveTheKeyboard) {
  applyTheme(*qApp, ThemeChoice::light);
  section().setFolded(false);
  table().setCurrentIndex(table().model()->index(1, 0));
  const auto edge = [this] {
    const QImage shown = table().grab().toImage();
    return shown.pixelColor(shown.width() / 2, shown.height() - 1);
  };
  view().setFocus();
  const QColor accent = themeColors(Look::light).accent;
  EXPECT_NE(edge(), accent);
  const int height = table().height();
  table().setFocus(Qt::TabFocusReason);
  ASSERT_TRUE(table().hasFocus());
  EXPECT_EQ(edge(), accent);
  EXPECT_EQ(table().height(), height);
}

TEST_F(LabelCurveWindow, aLabelGetsItsOwnCurveWhichThePanelThenEdits) {
  EXPECT_FALSE(whose().isVisible()) << "no label has one";
  toggleCurve(2);
  ASSERT_TRUE(test::waitUntil([this] { return whose().isVisible(); }));
  EXPECT_EQ(undo().undoText(), QStringLiteral("give Label 8 its own curve"));
  const TransferFunction begun = inOneColor(function, scene().keep.labels->labels()[2].color);
  EXPECT_EQ(curveOf(2), begun) << "the opacities of all tissue in the label's colour";
  EXPECT_EQ(whose().currentIndex(), 1);
  EXPECT_EQ(whose().currentText(), QStringLiteral("Label 8"));
  canvas().edit(red(), {nextGestureId(), QStringLiteral("change colour")});
  EXPECT_EQ(curveOf(2), red());
  EXPECT_EQ(curveOf(1), function);
  EXPECT_EQ(scene().transferFunction, function);
  EXPECT_EQ(canvas().transferFunction(), red());
  EXPECT_EQ(undo().undoText(), QStringLiteral("Label 8: change colour"));
  undo().undo();
  EXPECT_EQ(curveOf(2), begun);
  EXPECT_EQ(canvas().transferFunction(), begun);
  undo().undo();
  EXPECT_EQ(lookOfLabel(scene().keep, 2), 0u);
  EXPECT_FALSE(whose().isVisible());
}

TEST_F(LabelCurveWindow, thePictureShowsEachLabelByItsOwnCurve) {
  toggleCurve(2);
  canvas().edit(red(), {nextGestureId(), QStringLiteral("change colour")});
  ASSERT_TRUE(rest());
  // The patient's left, where x is large, is at the right of the picture.
  const std::array<double, 2> redness = rednessOfSides();
  EXPECT_GT(redness[1], 100.0);
  EXPECT_LT(redness[0], redness[1] - 50.0);
}

TEST_F(LabelCurveWindow, theHistogramCountsTheLabelsVoxelsAlone) {
  const auto plotWith = [this](const Histogram& histogram) {
    canvas().setHistogram(histogram);
    return canvas().grab().toImage();
  };
  toggleCurve(1);
  ASSERT_TRUE(test::waitUntil([this] { return whose().isVisible(); }));
  Region alone = withoutCuts(scene().keep);
  alone.weights = {0.0, 1.0, 0.0};
  const auto countedOf = [this](const Region& region) {
    return histogramOfKept(*scene().volume, KeptVoxels(scene().volume->grid(), region, scene().crop), 1024,
                           {});
  };
  const Histogram whole = countedOf({}), own = countedOf(alone);
  EXPECT_EQ(std::accumulate(own.counts.begin(), own.counts.end(), std::uint64_t{0}), 10u * 20u * 20u);
  // What the plot shows is told by what showing the label's own would change; it is put back where that is
  // not there yet, for only the panel shall bring it.
  EXPECT_TRUE(test::waitUntil([&] {
    const QImage shown = canvas().grab().toImage();
    const bool isOwn = plotWith(own) == shown;
    if (!isOwn)
      plotWith(whole);
    return isOwn;
  }));
  EXPECT_NE(plotWith(whole), plotWith(own));
}

TEST_F(LabelCurveWindow, aPresetShapesTheCurveInHandAndTheRestStays) {
  toggleCurve(1);
  emit window->findChild<PresetBrowser*>()->presetChosen(QStringLiteral("CT bone"));
  EXPECT_EQ(scene().transferFunction, function);
  EXPECT_NE(curveOf(1), function);
  whose().setCurrentIndex(0);
  emit whose().activated(0);
  EXPECT_EQ(canvas().transferFunction(), function);
  emit window->findChild<PresetBrowser*>()->presetChosen(QStringLiteral("CT muscle"));
  EXPECT_NE(scene().transferFunction, function);
}

TEST_F(LabelCurveWindow, aSecondClickGivesTheCurveOfAllTissueBack) {
  toggleCurve(1);
  toggleCurve(1);
  EXPECT_EQ(lookOfLabel(scene().keep, 1), 0u);
  EXPECT_EQ(undo().undoText(), QStringLiteral("give Label 3 the curve of all tissue"));
  EXPECT_EQ(canvas().transferFunction(), function);
}

TEST_F(LabelCurveWindow, sessionsKeepTheCurvesOfLabels) {
  toggleCurve(2);
  canvas().edit(red(), {nextGestureId(), QStringLiteral("change colour")});
  std::ofstream(folder.path() / "session.json") << sessionToJson(window->sessionDocument());
  ASSERT_TRUE(open(pathTo("session.json")));
  EXPECT_EQ(curveOf(2), red());
  EXPECT_EQ(scene().transferFunction, function);
}

TEST_F(LabelCurveWindow, sessionsComeBackToTheCurveThatWasInHand) {
  toggleCurve(1);
  toggleCurve(2);
  std::ofstream(folder.path() / "of_label.json") << sessionToJson(window->sessionDocument());
  emit whose().activated(0);
  std::ofstream(folder.path() / "of_all.json") << sessionToJson(window->sessionDocument());
  ASSERT_TRUE(open(pathTo("of_label.json")));
  EXPECT_EQ(whose().currentText(), QStringLiteral("Label 8"));
  EXPECT_EQ(canvas().transferFunction(), curveOf(2));
  EXPECT_FALSE(window->isWindowModified());
  ASSERT_TRUE(open(pathTo("of_all.json")));
  EXPECT_EQ(whose().currentIndex(), 0);
  EXPECT_EQ(canvas().transferFunction(), scene().transferFunction);
}

} // namespace
} // namespace limn
