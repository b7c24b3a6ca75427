// SPDX-License-Identifier: GPL-3.0-or-later
#include "ViewHost.h"
#include "scene/framing/Framing.h"
#include "support/CropHandle.h"

// How the camera follows what is visible and the shape of the pictures, in a real window.

namespace limn {
namespace {

using test::ViewHost;

class FramingInView : public ::testing::Test {
protected:
  void SetUp() override {
    QObject::connect(&host.view.input(), &ViewInput::cropEdited, [this](const CropBox& crop, const Gesture&) {
      host.scene.crop = crop;
      host.view.setScene(host.scene);
    });
    host.showPhantom();
    host.view.setCropBoxVisible(true);
    ASSERT_TRUE(host.show());
    ASSERT_TRUE(host.rest());
    host.view.resetCamera();
    ASSERT_TRUE(isFramedNow());
  }

  bool isFramedNow() const {
    return isFramed(host.scene.camera, host.scene.volume->grid(), visibleVoxels(host.scene),
                    host.view.pictureAspect());
  }

  void changeShape(const QSize& size) {
    host.view.resize(size);
    ASSERT_TRUE(test::waitUntil([&] { return host.view.windowHandle()->size() == size; }));
    ASSERT_TRUE(host.rest());
    QCoreApplication::processEvents(); // rest is told behind the turn in which it began
  }

  ViewHost host{{700, 400}};
};

TEST_F(FramingInView, everyLayoutFramesWhatIsVisible) {
  for (const CompareLayout layout : {CompareLayout::sideBySide, CompareLayout::single, CompareLayout::wipe,
                                     CompareLayout::sideBySide, CompareLayout::difference}) {
    host.view.setCompareLayout(layout);
    EXPECT_TRUE(isFramedNow()) << nameOf(layout);
  }
}

TEST_F(FramingInView, whoCameNearerStaysAsNearInAnotherLayout) {
  host.scene.camera = zoomed(host.scene.camera, 2.0);
  host.view.setScene(host.scene);
  host.view.setCompareLayout(CompareLayout::sideBySide);
  EXPECT_FALSE(isFramedNow());
  host.scene.camera = zoomed(host.scene.camera, 0.5);
  EXPECT_TRUE(isFramedNow());
}

TEST_F(FramingInView, aWindowOfAnotherShapeFramesWhatIsVisible) {
  changeShape({400, 400});
  EXPECT_TRUE(isFramedNow());
  changeShape({800, 300});
  EXPECT_TRUE(isFramedNow());
}

TEST_F(FramingInView, aCameraThatCameWithItsSceneStaysUntilThePicturesStand) {
  Scene opened = host.scene;
  opened.volume = phantomVolume({6.0, 0.0, 2});
  opened.camera = zoomed(orbited(opened.camera, 0.3, 0.2), 1.3);
  host.scene = opened;
  host.view.setScene(opened);
  host.view.setCompareLayout(CompareLayout::sideBySide); // as a session has it
  changeShape({500, 400});
  EXPECT_EQ(host.scene.camera, opened.camera);
  const double before = host.view.pictureAspect();
  host.view.setCompareLayout(CompareLayout::single);
  EXPECT_EQ(host.scene.camera, refitted(opened.camera, opened.volume->grid(), visibleVoxels(opened), before,
                                        host.view.pictureAspect()));
  EXPECT_NE(host.scene.camera, opened.camera) << before;
}

TEST_F(FramingInView, noCropMovesTheCamera) {
  const Camera before = host.scene.camera;
  const QPoint from = test::cropHandle(host.view, {0, true}).toPoint();
  const QPoint to = (from + test::cropHandle(host.view, {0, false}).toPoint()) / 2;
  host.press(from);
  host.move((from + to) / 2);
  host.move(to);
  ASSERT_NE(host.scene.crop, CropBox{});
  host.release(to);
  ASSERT_TRUE(host.rest());
  EXPECT_EQ(host.scene.camera, before);
  EXPECT_LE((test::cropHandle(host.view, {0, true}).toPoint() - to).manhattanLength(), 2)
      << "the handle stays where it was let go";
  host.scene.crop.upper.z = 0.5;
  host.view.setScene(host.scene);
  ASSERT_TRUE(host.rest());
  EXPECT_EQ(host.scene.camera, before);
  host.view.resetCamera();
  EXPECT_TRUE(isFramedNow()) << "R frames what is left";
}

} // namespace
} // namespace limn
