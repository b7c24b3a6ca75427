// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/files/saving/SavingController.h"
#include "scene/effects/EffectPlan.h"
#include "scene/presets/Preset.h"
#include "support/ShortVolume.h"
#include "widgets/FindWidget.h"
#include "widgets/controls/NumberField.h"
#include "widgets/controls/NumberSliders.h"
#include "widgets/controls/TrackSlider.h"
#include "widgets/properties/EffectsPanel.h"

#include <QUndoStack>

#include <cmath>

// Smooth normals in the program's window: as opening sets them, as the slider does, and what else follows.

namespace limn {
namespace {

constexpr int ballSize = 24;

int ballAt(const glm::ivec3& v, double sliceMm) {
  const glm::dvec3 away = (glm::dvec3(v) - 11.5) * glm::dvec3(1.0, 1.0, sliceMm);
  return static_cast<int>(std::clamp(60.0 * (11.0 - glm::length(away)), -1000.0, 500.0));
}

class SmoothNormalsWindow : public test::OpenGlWindow {
protected:
  [[nodiscard]] bool openBall(double sliceMm) {
    test::writeShorts(
        folder.path() / "ball.nrrd", ballSize, [&](const glm::ivec3& v) { return ballAt(v, sliceMm); },
        sliceMm);
    if (!open(pathTo("ball.nrrd")))
      return false;
    setLayout(CompareLayout::single);
    session().setTransferFunction({1.0, {{0.0, {0.9, 0.6, 0.5}, 0.0}, {100.0, {0.9, 0.9, 0.8}, 0.9}}},
                                  {nextGestureId(), "a ball"});
    Scene lit = scene();
    lit.projection = Projection::composite;
    lit.shading.model = ShadingModel::classic;
    session().edit(lit, {nextGestureId(), "lit"});
    return rest();
  }

  ValueSlider& slider() { return *rowNamed<ValueSlider>(*window, "Smooth normals"); }
  double smoothing() const { return scene().shading.gradientSmoothing; }
  QImage picture() { return view().grab().toImage(); }

  // Whether the Effects tab marks the row as on.
  bool isMarked() {
    for (const EffectRowWidget* row : window->findChildren<EffectRowWidget*>())
      if (row->accessibleName().startsWith(QStringLiteral("Smooth normals")))
        return row->accessibleName().endsWith(QStringLiteral("on"));
    ADD_FAILURE() << "no such row";
    return false;
  }
};

TEST_F(SmoothNormalsWindow, areOnWhereSlicesAreThickByAQuarterAndOffElsewhere) {
  ASSERT_TRUE(openBall(1.0));
  EXPECT_EQ(smoothing(), 0.0);
  EXPECT_FALSE(isMarked());
  ASSERT_TRUE(openBall(1.2));
  EXPECT_EQ(smoothing(), 0.0);
  ASSERT_TRUE(openBall(1.25));
  EXPECT_NEAR(smoothing(), 0.7 * 1.25, 1e-12);
  ASSERT_TRUE(openBall(4.0));
  EXPECT_NEAR(smoothing(), 0.7 * 4.0, 1e-12);
  EXPECT_TRUE(isMarked());
  EXPECT_TRUE(test::waitUntil([this] { return compiledPrograms() > 0; }));
}

TEST_F(SmoothNormalsWindow, theSliderSwitchesThemAndOneUndoTakesItBack) {
  ASSERT_TRUE(openBall(4.0));
  const QImage smooth = picture();
  undo().clear();
  auto* field = slider().findChild<NumberField*>();
  ASSERT_NE(field, nullptr);
  field->setFocus();
  field->selectAll();
  QTest::keyClicks(field, QStringLiteral("0"));
  QTest::keyClick(field, Qt::Key_Return);
  ASSERT_TRUE(test::waitUntil([this] { return smoothing() == 0.0; }));
  ASSERT_TRUE(rest());
  const QImage plain = picture();
  EXPECT_NE(plain, smooth);
  EXPECT_TRUE(test::waitUntil([this] { return !isMarked(); }));
  EXPECT_EQ(undo().count(), 1);
  undo().undo();
  EXPECT_NEAR(smoothing(), 2.8, 1e-12);
  ASSERT_TRUE(rest());
  EXPECT_TRUE(test::waitUntil([this] { return isMarked(); }));
}

TEST_F(SmoothNormalsWindow, aPresetLeavesThemAndARememberedLookDoesNot) {
  ASSERT_TRUE(openBall(4.0));
  Preset preset;
  preset.name = "other";
  preset.modality = "CT";
  preset.transferFunction = scene().transferFunction;
  preset.shading = Shading{};
  session().usePreset(preset, {nextGestureId(), "other"});
  EXPECT_NEAR(smoothing(), 2.8, 1e-12);
  preset.shading->gradientSmoothing = 1.5;
  session().usePreset(preset, {nextGestureId(), "other"});
  EXPECT_EQ(smoothing(), 1.5);
  preset.shading->gradientSmoothing = 0.0;
  preset.isWhole = true;
  EXPECT_EQ(withPreset(scene(), preset).shading.gradientSmoothing, 0.0);
}

TEST_F(SmoothNormalsWindow, theLookOfTheVolumeBeforeBringsThoseThatWereSetByHandAlone) {
  ASSERT_TRUE(openBall(4.0));
  ASSERT_TRUE(openBall(1.0));
  QTest::keyClick(window.get(), Qt::Key_L, Qt::ControlModifier);
  EXPECT_EQ(smoothing(), 0.0) << "they were of thick slices";
  Scene smooth = scene();
  smooth.shading.gradientSmoothing = 1.5;
  session().edit(smooth, {nextGestureId(), "smooth"});
  ASSERT_TRUE(openBall(4.0));
  EXPECT_NEAR(smoothing(), 2.8, 1e-12);
  QTest::keyClick(window.get(), Qt::Key_L, Qt::ControlModifier);
  EXPECT_EQ(smoothing(), 1.5);
  undo().undo();
  EXPECT_NEAR(smoothing(), 2.8, 1e-12);
}

TEST_F(SmoothNormalsWindow, aSavedSceneKeepsWhatItSays) {
  ASSERT_TRUE(openBall(4.0));
  Scene plain = scene();
  plain.shading.gradientSmoothing = 0.0;
  session().edit(plain, {nextGestureId(), "plain"});
  const QString saved = pathTo("plain.limn.json");
  typeName(saved);
  saving().saveSession();
  ASSERT_TRUE(test::waitUntil([&] { return QFile::exists(saved); }));
  ASSERT_TRUE(open(saved));
  EXPECT_EQ(smoothing(), 0.0);
}

} // namespace
} // namespace limn
