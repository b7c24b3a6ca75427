// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "scene/framing/VisibleVoxels.h"
#include "support/CropHandle.h"
#include "widgets/FindWidget.h"
#include "widgets/PresetNames.h"
#include "widgets/controls/NumberField.h"
#include "widgets/curve/CurvePanel.h"
#include "widgets/curve/GradientOpacityEditor.h"
#include "widgets/curve/TransferFunctionEditor.h"
#include "widgets/curve/canvas/TransferFunctionCanvas.h"
#include "widgets/presets/PresetBrowser.h"
#include "widgets/properties/CropSection.h"
#include "widgets/properties/PropertiesPanel.h"

#include <QCheckBox>
#include <QInputDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeView>

// Crop, projection and the curve over the gradient in the program's window.

namespace limn {
namespace {

class MainWindowScene : public test::OpenGlWindow {
protected:
  void SetUp() override {
    OpenGlWindow::SetUp();
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:4")));
    session().setCamera(orbited(scene().camera, 0.5, 0.4));
  }

  PropertiesPanel& properties() { return *window->findChild<PropertiesPanel*>(); }
  GradientOpacityEditor& gradientEditor() { return *curves().gradientEditor(); }

  QPoint handle(CropFace face) {
    return view().mapTo(window.get(), test::cropHandle(view(), face).toPoint());
  }
  void press(const QPoint& at) { QTest::mousePress(window->windowHandle(), Qt::LeftButton, {}, at); }
  void move(const QPoint& to) {
    QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, {}, to);
    QCoreApplication::processEvents();
  }
  void release(const QPoint& at) { QTest::mouseRelease(window->windowHandle(), Qt::LeftButton, {}, at); }

  QCheckBox* useBox() {
    return widgetNamed<QCheckBox>(gradientEditor(), "Use the curve of opacity over the gradient");
  }
  [[nodiscard]] bool gradientsCounted() {
    return test::waitUntil([this] { return useBox()->isEnabled(); });
  }

  void saveAsPreset(const QString& name) {
    emit window->findChild<PresetBrowser*>()->saveRequested();
    auto* dialog = window->findChild<QInputDialog*>();
    dialog->setTextValue(name);
    dialog->accept();
  }
};

TEST_F(MainWindowScene, draggingAHandleOfTheCropBoxIsOneUndoStep) {
  view().setFocus();
  QTest::keyClick(&view(), Qt::Key_B);
  ASSERT_TRUE(view().cropBoxIsVisible());
  const QPoint from = handle({2, true});
  press(from);
  for (int step = 1; step <= 4; ++step)
    move(from + QPoint(0, 10 * step));
  release(from + QPoint(0, 40));
  const CropBox cut = scene().crop;
  EXPECT_LT(cut.upper.z, 0.95);
  EXPECT_EQ(undo().count(), 1);
  EXPECT_EQ(undo().undoText(), QStringLiteral("move crop face: Head"));
  ASSERT_TRUE(rest());
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(scene().crop, CropBox{});
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(scene().crop, cut);
}

TEST_F(MainWindowScene, escapeLeavesNoUndoStepOfACropDrag) {
  action(QStringLiteral("&Crop box"))->trigger();
  const QPoint from = handle({0, true});
  press(from);
  move(from - QPoint(20, 0));
  move(from - QPoint(40, 0));
  ASSERT_NE(scene().crop, CropBox{});
  QTest::keyClick(&view(), Qt::Key_Escape);
  release(from - QPoint(40, 0));
  EXPECT_EQ(scene().crop, CropBox{});
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(MainWindowScene, theCropBoxShowsWhileItsSectionIsUsedAndOnIntoTheView) {
  CropSection* section = properties().cropSection();
  section->setFolded(false);
  EXPECT_FALSE(view().cropBoxIsVisible());
  section->findChild<NumberField*>()->setFocus();
  EXPECT_TRUE(view().cropBoxIsVisible());
  view().setFocus();
  EXPECT_TRUE(view().cropBoxIsVisible());
  window->findChild<PresetBrowser*>()->findChild<QLineEdit*>()->setFocus();
  EXPECT_FALSE(view().cropBoxIsVisible());
  view().setFocus();
  EXPECT_FALSE(view().cropBoxIsVisible());
}

// What nobody edits any more and is switched off is not shown for the sake of where one came from.
TEST_F(MainWindowScene, theCropBoxGoesWithItsKeyAndWithItsFoldedSection) {
  CropSection* section = properties().cropSection();
  section->setFolded(false);
  section->findChild<NumberField*>()->setFocus();
  view().setFocus();
  ASSERT_TRUE(view().cropBoxIsVisible());
  QTest::keyClick(&view(), Qt::Key_B);
  EXPECT_TRUE(view().cropBoxIsVisible());
  QTest::keyClick(&view(), Qt::Key_B);
  EXPECT_FALSE(view().cropBoxIsVisible());
  section->setFolded(true);
  section->findChild<FoldingHeader*>()->setFocus();
  EXPECT_FALSE(view().cropBoxIsVisible()) << "on the way along the titles";
  view().setFocus();
  EXPECT_FALSE(view().cropBoxIsVisible());
}

TEST_F(MainWindowScene, theCropBoxIsDrawnCloseAroundWhatIsSeen) {
  properties().cropSection()->setFolded(false);
  QCoreApplication::processEvents();
  auto* button = widgetNamed<QPushButton>(*properties().cropSection(), "Crop to what is seen");
  const IndexBox seen = visibleBox(scene());
  QTest::mouseClick(button, Qt::LeftButton);
  const IndexBox left = croppedBox(scene().volume->grid(), scene().crop);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(left.lower[axis], seen.lower[axis], 1e-9);
    EXPECT_NEAR(left.upper[axis], seen.upper[axis], 1e-9);
  }
  EXPECT_NE(scene().crop, CropBox{}) << "there is air around the head";
  EXPECT_EQ(undo().undoText(), QStringLiteral("crop to what is seen"));
  const CropBox once = scene().crop;
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(scene().crop, once) << "again changes nothing";
}

TEST_F(MainWindowScene, theLetterOfTheCropBoxCanBeTypedElsewhere) {
  QLineEdit* search = window->findChild<PresetBrowser*>()->findChild<QLineEdit*>();
  search->setFocus();
  QTest::keyClick(search, Qt::Key_B);
  EXPECT_FALSE(view().cropBoxIsVisible());
  EXPECT_EQ(search->text(), QStringLiteral("b"));
}

TEST_F(MainWindowScene, gradientsAreCountedOnlyOnceTheirCurveIsLookedAt) {
  QCoreApplication::processEvents();
  EXPECT_FALSE(useBox()->isEnabled());
  curves().showGradient(true);
  ASSERT_TRUE(gradientsCounted());
  curves().showGradient(false);
  curves().showGradient(true);
  EXPECT_TRUE(useBox()->isEnabled());             // and not again
  ASSERT_TRUE(open(QStringLiteral("phantom:5"))); // another volume, whose curve is in view
  EXPECT_TRUE(gradientsCounted());
}

TEST_F(MainWindowScene, theCurveOverTheGradientIsSwitchedOnDraggedAndUndone) {
  curves().showGradient(true);
  ASSERT_TRUE(gradientsCounted());
  QCheckBox* use = useBox();
  QTest::mouseClick(use, Qt::LeftButton, {}, {8, use->height() / 2});
  ASSERT_TRUE(scene().gradientOpacity);
  const GradientOpacity ramp = *scene().gradientOpacity;
  EXPECT_EQ(undo().undoText(), QStringLiteral("use opacity over gradient"));
  EXPECT_TRUE(rest());

  TransferFunctionCanvas& canvas = *gradientEditor().editor()->canvas();
  const QPoint from = canvas.mapTo(
      window.get(), positionOf(canvas.transform(), canvas.transferFunction().points[1]).toPoint());
  press(from);
  move(from + QPoint(5, 10));
  move(from + QPoint(10, 20));
  release(from + QPoint(10, 20));
  EXPECT_EQ(undo().count(), 2);
  EXPECT_GT(scene().gradientOpacity->points[1].gradient, ramp.points[1].gradient);
  EXPECT_LT(scene().gradientOpacity->points[1].opacity, 1.0);

  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(scene().gradientOpacity, ramp);
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(scene().gradientOpacity);
  EXPECT_FALSE(use->isChecked());
}

TEST_F(MainWindowScene, aSurfaceBeginsAtAValueThatTheVolumeHas) {
  Scene far = scene();
  far.isovalue = 1e6;
  session().edit(far, {nextGestureId(), QStringLiteral("far")});
  emit properties().projectionEdited(Projection::isosurface, {nextGestureId(), QStringLiteral("surface")});
  EXPECT_EQ(scene().projection, Projection::isosurface);
  EXPECT_GT(scene().isovalue, scene().volume->range().lowest);
  EXPECT_LT(scene().isovalue, scene().volume->range().highest);
  EXPECT_TRUE(rest());
  EXPECT_FALSE(messages().isVisible()) << messages().sentence().toStdString();
}

TEST_F(MainWindowScene, theSurfaceOfAVolumeInHounsfieldUnitsBeginsAtBone) {
  emit properties().projectionEdited(Projection::isosurface, {nextGestureId(), QStringLiteral("surface")});
  EXPECT_EQ(scene().isovalue, 300.0);
}

TEST_F(MainWindowScene, aPresetKeepsCurveOverTheGradientAndSurface) {
  Scene shaped = scene();
  shaped.gradientOpacity = GradientOpacity{{{5.0, 0.25}, {80.0, 0.75}}};
  shaped.projection = Projection::compositeIsosurface;
  shaped.isovalue = 123.5;
  session().edit(shaped, {nextGestureId(), QStringLiteral("shape")});
  saveAsPreset(QStringLiteral("Mine"));
  Scene plain = shaped;
  plain.gradientOpacity.reset();
  plain.projection = Projection::composite;
  plain.isovalue = 300.0;
  session().edit(plain, {nextGestureId(), QStringLiteral("plain")});
  auto& browser = *window->findChild<PresetBrowser*>();
  EXPECT_EQ(shownPreset(browser), QStringLiteral("Mine*"));
  emit browser.presetChosen(QStringLiteral("Mine"));
  EXPECT_EQ(scene().gradientOpacity, shaped.gradientOpacity);
  EXPECT_EQ(scene().projection, shaped.projection);
  EXPECT_EQ(scene().isovalue, shaped.isovalue);
  EXPECT_TRUE(useBox()->isChecked());
  EXPECT_EQ(shownPreset(browser), QStringLiteral("Mine"));
}

} // namespace
} // namespace limn
