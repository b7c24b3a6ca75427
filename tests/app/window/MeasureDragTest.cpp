// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/picture/CameraController.h"
#include "widgets/view/gestures/ViewInput.h"
#include "widgets/view/overlay/Overlay.h"

// What a drag measures in the picture, in the program's window.

namespace limn {
namespace {

using Kind = Measurement::Kind;

class MeasureDrag : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    window->resize(1280, 800);
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:4")));
    ASSERT_TRUE(rest());
  }

  const std::vector<Measurement>& measurements() const { return session().measurements(); }
  const std::vector<SeenMeasure>& seen() { return view().order().comparison.measures; }

  // Logical pixels from the middle of the picture.
  std::optional<glm::dvec3> placeSeen(const QPoint& fromMiddle) {
    const QPointF at = view().logicalRect(0).center().toPoint() + fromMiddle;
    const auto ray = rayUnder(view().order().geometry, scene().camera, at);
    return ray ? turnCentreAlong(view(), *ray, 0).placeMm : std::nullopt;
  }
  QPoint inPicture(const QPoint& fromMiddle) {
    return view().mapTo(window.get(), view().logicalRect(0).center().toPoint()) + fromMiddle;
  }
  QPoint besideTissue() {
    const QRect picture = view().logicalRect(0).toRect();
    for (int x = picture.width() / 2 - 6; x > 0; x -= 8)
      if (const QPoint fromMiddle(x, picture.height() / 4); !placeSeen(fromMiddle))
        return inPicture(fromMiddle);
    ADD_FAILURE() << "tissue everywhere";
    return inPicture({0, 0});
  }

  void hold(const QPoint& from, const QPoint& to) {
    QWindow* handle = window->windowHandle();
    QTest::mousePress(handle, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 5; ++step)
      QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, from + (to - from) * step / 5);
  }
  void letGo(const QPoint& at) {
    QTest::mouseRelease(window->windowHandle(), Qt::LeftButton, {}, at);
    QCoreApplication::processEvents();
  }
  void drag(const QPoint& from, const QPoint& to) {
    hold(from, to);
    letGo(to);
  }
  void press(Qt::Key key) {
    view().setFocus();
    QTest::keyClick(&view(), key);
    QCoreApplication::processEvents();
  }
};

TEST_F(MeasureDrag, overTissueMeasuresFromPressToRelease) {
  press(Qt::Key_D);
  const Camera camera = scene().camera;
  const glm::dvec3 first = placeSeen({-20, 0}).value(), second = placeSeen({25, 10}).value();
  hold(inPicture({-20, 0}), inPicture({25, 10}));
  EXPECT_TRUE(measurements().empty());
  ASSERT_EQ(seen().size(), 1u);
  EXPECT_EQ(seen().front().placesMm.size(), 2u) << "it is seen on its way";
  letGo(inPicture({25, 10}));
  ASSERT_EQ(measurements().size(), 1u);
  EXPECT_EQ(measurements().front().kind, Kind::distance);
  EXPECT_LT(glm::length(measurements().front().placesMm[0] - first), 1e-9);
  EXPECT_LT(glm::length(measurements().front().placesMm[1] - second), 1e-9);
  EXPECT_EQ(scene().camera, camera);
  EXPECT_EQ(undo().count(), 1);
}

TEST_F(MeasureDrag, besideTissueTurns) {
  press(Qt::Key_D);
  const Camera camera = scene().camera;
  const QPoint from = besideTissue();
  drag(from, from + QPoint(-15, 0));
  EXPECT_NE(scene().camera, camera);
  EXPECT_TRUE(measurements().empty());
  EXPECT_TRUE(seen().empty());
}

// Its other places may lie on another side of the body.
TEST_F(MeasureDrag, isTheFirstLegOfAnAngleAndThenTurns) {
  press(Qt::Key_G);
  const Camera camera = scene().camera;
  drag(inPicture({-30, 20}), inPicture({0, 20}));
  EXPECT_EQ(scene().camera, camera);
  ASSERT_EQ(seen().size(), 1u);
  EXPECT_EQ(seen().front().placesMm.size(), 2u);
  drag(inPicture({0, 50}), inPicture({15, 50}));
  EXPECT_NE(scene().camera, camera);
  EXPECT_TRUE(measurements().empty());
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, inPicture({0, -30}));
  ASSERT_EQ(measurements().size(), 1u);
  EXPECT_EQ(measurements().front().kind, Kind::angle);
  EXPECT_EQ(measurements().front().placesMm.size(), 3u);
}

TEST_F(MeasureDrag, isTakenBackByEscAndTheToolStays) {
  press(Qt::Key_D);
  hold(inPicture({-20, 0}), inPicture({25, 10}));
  press(Qt::Key_Escape);
  EXPECT_TRUE(seen().empty());
  letGo(inPicture({25, 10}));
  EXPECT_TRUE(measurements().empty());
  EXPECT_TRUE(seen().empty());
  EXPECT_EQ(view().tool(), ViewTool::distance);
}

TEST_F(MeasureDrag, isFaintOnceItsTissueIsCroppedOrCutAway) {
  press(Qt::Key_D);
  drag(inPicture({-20, 0}), inPicture({25, 10}));
  ASSERT_EQ(measurements().size(), 1u);
  const auto isFaint = [this] { return seen().front().isHidden[0]; };
  ASSERT_TRUE(rest());
  EXPECT_FALSE(isFaint());
  CropBox behind;
  behind.lower.y = 0.5;
  session().setCrop(behind, {nextGestureId(), QStringLiteral("crop")});
  EXPECT_TRUE(test::waitUntil([&] { return isFaint(); })) << "its place lies in front";
  undo().undo();
  EXPECT_TRUE(test::waitUntil([&] { return !isFaint(); }));
  press(Qt::Key_X);
  for (const QPoint& corner : {QPoint(-60, -60), QPoint(60, -60), QPoint(60, 60), QPoint(-60, 60)})
    QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, inPicture(corner));
  press(Qt::Key_Return);
  EXPECT_TRUE(test::waitUntil([&] { return isFaint(); }));
  EXPECT_EQ(scene().keep.cuts.size(), 1u);
}

TEST_F(MeasureDrag, thatEndsBesideThePictureOrWhereItBeganMeasuresNothing) {
  press(Qt::Key_D);
  hold(inPicture({-20, 0}), inPicture({25, 10}));
  letGo({5, 5});
  EXPECT_TRUE(seen().empty());
  hold(inPicture({-20, 0}), inPicture({25, 10}));
  letGo(inPicture({-20, 0}));
  EXPECT_TRUE(seen().empty());
  EXPECT_TRUE(measurements().empty());
  EXPECT_EQ(undo().count(), 0);
  EXPECT_EQ(view().tool(), ViewTool::distance);
}

} // namespace
} // namespace limn
