// SPDX-License-Identifier: GPL-3.0-or-later
#include "ViewHost.h"
#include "support/CropHandle.h"
#include "widgets/view/gestures/ViewInput.h"

#include <QSignalSpy>

// The crop box with real mouse events, in a real window.

namespace limn {
namespace {

using test::ViewHost;

class CropBoxInView : public testing::TestWithParam<CompareLayout> {
protected:
  void SetUp() override {
    QObject::connect(&host.view.input(), &ViewInput::cropEdited,
                     [this](const CropBox& crop, const Gesture& gesture) {
                       gestures.push_back(gesture);
                       host.scene.crop = crop;
                       host.view.setScene(host.scene);
                     });
    host.showPhantom();
    host.scene.camera = orbited(host.scene.camera, 0.6, 0.4);
    host.view.setScene(host.scene);
    host.view.setCompareLayout(GetParam());
    host.view.setCropBoxVisible(true);
    ASSERT_TRUE(host.show());
  }

  QPoint handle(CropFace face) const {
    const int last = GetParam() == CompareLayout::sideBySide ? 1 : 0;
    return test::cropHandle(host.view, face, last).toPoint();
  }

  ViewHost host{{700, 400}};
  std::vector<Gesture> gestures;
};

TEST_P(CropBoxInView, aDragMovesOneFaceUnderThePointerAsOneGesture) {
  const CropFace face{0, true};
  const QPoint from = handle(face);
  // Half way to the opposite face.
  const QPoint to = (from + handle({0, false})) / 2;
  const Camera camera = host.scene.camera;
  host.drag(from, to);
  ASSERT_GE(gestures.size(), 2u);
  EXPECT_EQ(gestures.front().id, gestures.back().id);
  EXPECT_TRUE(gestures.front().text.contains(QStringLiteral("crop")));
  EXPECT_EQ(host.cameraEdits, 0);
  EXPECT_EQ(host.scene.camera, camera);
  CropBox others = host.scene.crop;
  others.upper.x = 1.0;
  EXPECT_EQ(others, CropBox{});
  EXPECT_GT(host.scene.crop.upper.x, 0.3);
  EXPECT_LT(host.scene.crop.upper.x, 0.7);
  // The handle is where the pointer let go, to the pixel both were rounded to.
  const QPoint now = handle(face);
  EXPECT_NEAR(now.x(), to.x(), 2);
  EXPECT_NEAR(now.y(), to.y(), 2);
}

TEST_P(CropBoxInView, escapePutsTheFaceBack) {
  const QPoint from = handle({2, true});
  host.press(from);
  host.move(from + QPoint(0, 40));
  ASSERT_NE(host.scene.crop, CropBox{});
  QTest::keyClick(&host.view, Qt::Key_Escape);
  EXPECT_EQ(host.scene.crop, CropBox{});
  EXPECT_EQ(gestures.front().id, gestures.back().id);
  host.move(from + QPoint(0, 60));
  host.release(from + QPoint(0, 60));
  EXPECT_EQ(host.scene.crop, CropBox{});
}

TEST_P(CropBoxInView, aFaceStopsOneVoxelBeforeTheOpposite) {
  const QPoint from = handle({0, true});
  const QPoint opposite = handle({0, false});
  host.drag(from, opposite + (opposite - from));
  EXPECT_EQ(host.scene.crop.lower.x, 0.0);
  EXPECT_DOUBLE_EQ(host.scene.crop.upper.x, 1.0 / host.scene.volume->grid().dims.x);
}

INSTANTIATE_TEST_SUITE_P(Layouts, CropBoxInView,
                         testing::Values(CompareLayout::single, CompareLayout::sideBySide));

class CropBoxInSingleView : public CropBoxInView {};

TEST_P(CropBoxInSingleView, theHandleAnswersThePointerAndADoubleClickUncutsItsFace) {
  const QPoint from = handle({2, true});
  host.move(from);
  EXPECT_NE(host.view.cursor().shape(), Qt::ArrowCursor);
  host.move({5, 390});
  EXPECT_EQ(host.view.cursor().shape(), Qt::ArrowCursor);
  host.drag(from, from + QPoint(0, 40));
  ASSERT_LT(host.scene.crop.upper.z, 1.0);
  QSignalSpy maximise(&host.view.input(), &ViewInput::maximiseRequested);
  QTest::mouseDClick(host.view.windowHandle(), Qt::LeftButton, {}, handle({2, true}));
  EXPECT_EQ(host.scene.crop, CropBox{});
  EXPECT_EQ(maximise.count(), 0);
}

// Front and back in a standard view, which move along the line of sight.
TEST_P(CropBoxInSingleView, facesAcrossTheLineOfSightAreDraggedToo) {
  host.scene.camera = standardView(host.scene.camera, host.scene.volume->grid(), StandardView::anterior);
  host.view.setScene(host.scene);
  const auto faces =
      cropBoxShape({}, host.scene.volume->grid(), viewProjection(host.scene.camera, host.view.logicalRect(0)))
          .handles;
  int dragged = 0;
  for (const CropHandle& one : faces) {
    if (!one.isAcross)
      continue;
    const QPoint from = handle(one.face);
    const CropBox before = host.scene.crop;
    host.drag(from, (QPointF(from) - 40.0 * one.outward).toPoint());
    EXPECT_NE(placeOf(host.scene.crop, one.face), placeOf(before, one.face));
    CropBox others = host.scene.crop;
    (one.face.isUpper ? others.upper : others.lower)[one.face.axis] = placeOf(before, one.face);
    EXPECT_EQ(others, before) << "the others stay";
    ++dragged;
  }
  EXPECT_EQ(dragged, 2);
  EXPECT_EQ(host.cameraEdits, 0);
}

TEST_P(CropBoxInSingleView, withoutTheBoxTheSameDragRotates) {
  const QPoint from = handle({0, true});
  host.view.setCropBoxVisible(false);
  host.drag(from, from - QPoint(40, 0));
  EXPECT_EQ(host.scene.crop, CropBox{});
  EXPECT_GT(host.cameraEdits, 0);
}

TEST_P(CropBoxInSingleView, theBoxLeavesThePictureAtRestAsItIs) {
  ASSERT_TRUE(host.rest());
  const auto picture = host.view.restingImage(0);
  host.view.setCropBoxVisible(false);
  host.view.setCropBoxVisible(true);
  host.move(handle({0, true}));
  QCoreApplication::processEvents();
  EXPECT_TRUE(host.view.pictureState().resting); // nothing is drawn anew for it
  EXPECT_TRUE(host.view.restingImage(0) == picture);
}

INSTANTIATE_TEST_SUITE_P(Layouts, CropBoxInSingleView, testing::Values(CompareLayout::single));

} // namespace
} // namespace limn
