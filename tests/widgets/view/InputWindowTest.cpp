// SPDX-License-Identifier: GPL-3.0-or-later
#include "ViewHost.h"
#include "scene/framing/Framing.h"
#include "widgets/view/gestures/ViewInput.h"

#include <QMenu>
#include <QSignalSpy>

// Mouse and keys of the view, in a real window.

namespace limn {
namespace {

using test::ViewHost;

class ViewInput : public ::testing::Test {
protected:
  void SetUp() override {
    host.showPhantom();
    ASSERT_TRUE(host.show());
  }

  double distance() const { return glm::length(host.scene.camera.position - host.scene.camera.target); }

  ViewHost host;
};

TEST_F(ViewInput, leftDragRotatesAboutTheTarget) {
  const Camera before = host.scene.camera;
  const double distanceBefore = distance();
  host.drag({200, 120}, {240, 120});
  EXPECT_GE(host.cameraEdits, 2);
  EXPECT_EQ(host.scene.camera.target, before.target);
  EXPECT_NEAR(distance(), distanceBefore, 1e-9 * distanceBefore);
  // To the right: the camera goes to the patient's right, -x.
  EXPECT_LT(host.scene.camera.position.x, before.position.x - 1.0);
}

TEST_F(ViewInput, holdingStillInADragRefinesThePicture) {
  host.press({200, 120});
  host.move({230, 120});
  EXPECT_FALSE(host.view.pictureState().resting);
  EXPECT_TRUE(host.rest());
  host.release({230, 120});
}

TEST_F(ViewInput, middleDragAndShiftLeftDragPanAlike) {
  const Camera before = host.scene.camera;
  host.drag({200, 120}, {230, 100}, Qt::MiddleButton);
  const Camera middle = host.scene.camera;
  EXPECT_NE(middle.target, before.target);
  host.scene.camera = before;
  host.view.setScene(host.scene);
  host.drag({200, 120}, {230, 100}, Qt::LeftButton, Qt::ShiftModifier);
  EXPECT_NEAR(glm::length(host.scene.camera.target - middle.target), 0.0, 1e-9);
}

TEST_F(ViewInput, rightDragWheelAndPlusZoom) {
  const double before = distance();
  host.drag({200, 120}, {200, 90}, Qt::RightButton);
  const double dragged = distance();
  EXPECT_LT(dragged, before);
  QWheelEvent wheel({200, 120}, host.view.mapToGlobal(QPointF(200, 120)), {}, {0, 120}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QCoreApplication::sendEvent(&host.view, &wheel);
  EXPECT_NEAR(distance(), dragged / 1.2, 1e-9);
  QTest::keyClick(&host.view, Qt::Key_Plus);
  EXPECT_NEAR(distance(), dragged / 1.44, 1e-9);
}

TEST_F(ViewInput, controlLeftDragRolls) {
  const CameraBasis before = basisOf(host.scene.camera);
  host.drag({300, 120}, {200, 200}, Qt::LeftButton, Qt::ControlModifier);
  const CameraBasis after = basisOf(host.scene.camera);
  EXPECT_NEAR(glm::dot(before.forward, after.forward), 1.0, 1e-12);
  EXPECT_NEAR(glm::dot(before.up, after.up), 0.0, 1e-9); // a quarter turn
}

TEST_F(ViewInput, altDragChangesTheWindowAsOneGesture) {
  const TransferFunction before = host.scene.transferFunction;
  host.drag({200, 120}, {240, 120}, Qt::LeftButton, Qt::AltModifier);
  ASSERT_GE(host.gestures.size(), 2u);
  EXPECT_EQ(host.gestures.front().id, host.gestures.back().id);
  EXPECT_GT(host.scene.transferFunction.points.back().value, before.points.back().value);
  EXPECT_EQ(host.cameraEdits, 0);
  const auto firstId = host.gestures.back().id;
  QTest::keyClick(&host.view, Qt::Key_W);
  host.drag({200, 120}, {200, 100});
  EXPECT_NE(host.gestures.back().id, firstId);
}

TEST_F(ViewInput, controlAltDragChangesTheOpacity) {
  const double before = host.scene.transferFunction.points[1].opacity;
  host.drag({200, 150}, {200, 50}, Qt::LeftButton, Qt::AltModifier | Qt::ControlModifier);
  EXPECT_NEAR(host.scene.transferFunction.points[1].opacity, 2.0 * before, 1e-12); // 100 pixels up
  EXPECT_EQ(host.scene.transferFunction.points[0].opacity, 0.0);
}

TEST_F(ViewInput, escapeCancelsADrag) {
  const Scene before = host.scene;
  host.press({200, 120}, Qt::LeftButton, Qt::AltModifier);
  host.move({250, 100}, Qt::AltModifier);
  EXPECT_NE(host.scene.transferFunction, before.transferFunction);
  QTest::keyClick(&host.view, Qt::Key_Escape);
  EXPECT_EQ(host.scene.transferFunction, before.transferFunction);
  EXPECT_EQ(host.gestures.front().id, host.gestures.back().id);
  host.move({300, 100}); // no longer a drag
  host.release({300, 100});
  EXPECT_EQ(host.scene, before);

  host.press({200, 120});
  host.move({250, 100});
  EXPECT_NE(host.scene.camera, before.camera);
  QTest::keyClick(&host.view, Qt::Key_Escape);
  EXPECT_EQ(host.scene.camera, before.camera);
  host.release({250, 100});
}

TEST_F(ViewInput, keysChooseStandardViewsAndRotate) {
  const Grid& grid = host.scene.volume->grid();
  const auto lookFrom = [&](StandardView view) {
    return framed(standardView(host.scene.camera, grid, view), grid, visibleVoxels(host.scene),
                  host.view.pictureAspect());
  };
  const Camera front = lookFrom(StandardView::anterior);
  QTest::keyClick(&host.view, Qt::Key_PageDown);
  EXPECT_EQ(host.scene.camera, lookFrom(StandardView::left));
  QTest::keyClick(&host.view, Qt::Key_PageDown, Qt::ShiftModifier);
  EXPECT_EQ(host.scene.camera, lookFrom(StandardView::right));
  QTest::keyClick(&host.view, Qt::Key_S);
  EXPECT_EQ(host.scene.camera, lookFrom(StandardView::superior));
  QTest::keyClick(&host.view, Qt::Key_R);
  EXPECT_EQ(host.scene.camera, front);
  QTest::keyClick(&host.view, Qt::Key_Left);
  EXPECT_GT(host.scene.camera.position.x, front.position.x);
  QTest::keyClick(&host.view, Qt::Key_Insert);
  EXPECT_EQ(host.scene.camera, front);
}

TEST_F(ViewInput, shiftMoveProbesAndShiftClickPins) {
  ASSERT_TRUE(host.rest());
  QSignalSpy pins(&host.view.input(), &limn::ViewInput::pinRequested);
  host.move({200, 120}, Qt::ShiftModifier);
  ASSERT_FALSE(host.probes.empty());
  ASSERT_TRUE(host.probes.back().has_value());
  const Probe probe = *host.probes.back();
  EXPECT_GT(probe.value, -300.0);
  EXPECT_LT(probe.positionMm.y, 0.0); // from the front one sees the front half
  host.press({200, 120}, Qt::LeftButton, Qt::ShiftModifier);
  host.release({200, 120}, Qt::LeftButton, Qt::ShiftModifier);
  ASSERT_EQ(pins.count(), 1);
  EXPECT_EQ(pins[0][0].toDouble(), probe.value);
  EXPECT_EQ(host.cameraEdits, 0);
  host.move({210, 120});
  EXPECT_FALSE(host.probes.back().has_value());
}

TEST_F(ViewInput, draggingTheWipeBorderMovesItAndNotTheCamera) {
  host.view.setCompareLayout(CompareLayout::wipe);
  QSignalSpy moved(&host.view, &CompareView::wipeMoved);
  host.drag({207, 200}, {100, 200}); // seven pixels beside the border
  EXPECT_GE(moved.count(), 1);
  EXPECT_NEAR(host.view.wipePosition(), 0.25, 1e-9);
  EXPECT_EQ(host.cameraEdits, 0);
  host.drag({207, 200}, {220, 200}); // where it no longer is
  EXPECT_GT(host.cameraEdits, 0);
}

TEST_F(ViewInput, aClickOnALabelChoosesTheModelOfThatSide) {
  host.view.setCompareLayout(CompareLayout::sideBySide);
  int chosenSide = -1;
  std::optional<ShadingModel> chosen;
  QObject::connect(&host.view, &CompareView::modelChosen, [&](int side, ShadingModel model) {
    chosenSide = side;
    chosen = model;
  });
  QTest::mouseClick(host.view.windowHandle(), Qt::LeftButton, {}, {225, 20}); // the right side's corner
  auto* menu = host.view.findChild<QMenu*>();
  ASSERT_NE(menu, nullptr);
  ASSERT_EQ(menu->actions().size(), 8);         // five models, a line, the presets, the swap of sides
  EXPECT_TRUE(menu->actions()[2]->isChecked()); // enhanced
  menu->actions()[3]->trigger();
  menu->close();
  EXPECT_EQ(chosenSide, 1);
  EXPECT_EQ(chosen, ShadingModel::robust);
  EXPECT_EQ(host.cameraEdits, 0);
}

TEST_F(ViewInput, theTitleOfTheDifferenceExplainsItAndTheLabelsStillChoose) {
  host.view.setCompareLayout(CompareLayout::difference);
  host.move({200, 48}); // under the two labels, between which the title does not fit
  EXPECT_TRUE(host.view.toolTip().contains(QStringLiteral("differ")));
  host.move({200, 150});
  EXPECT_TRUE(host.view.toolTip().isEmpty());
  QTest::mouseClick(host.view.windowHandle(), Qt::LeftButton, {}, {370, 20}); // the right half's label
  auto* menu = host.view.findChild<QMenu*>();
  ASSERT_NE(menu, nullptr);
  EXPECT_TRUE(menu->actions()[2]->isChecked()); // enhanced
  menu->close();
}

TEST_F(ViewInput, doubleClickAsksToMaximise) {
  QSignalSpy maximise(&host.view.input(), &limn::ViewInput::maximiseRequested);
  QTest::mouseDClick(host.view.windowHandle(), Qt::LeftButton, {}, {200, 150});
  EXPECT_EQ(maximise.count(), 1);
  EXPECT_EQ(host.cameraEdits, 0);
}

TEST_F(ViewInput, programKeysAreAskedFor) {
  QSignalSpy presets(&host.view.input(), &limn::ViewInput::windowPresetRequested);
  QTest::keyClick(&host.view, Qt::Key_3);
  ASSERT_EQ(presets.count(), 1);
  EXPECT_EQ(presets[0][0].toInt(), 3);
  QTest::keyClick(&host.view, Qt::Key_W);
  host.drag({200, 120}, {240, 120});
  EXPECT_FALSE(host.gestures.empty()) << "the left button now changes the window";
}

} // namespace
} // namespace limn
