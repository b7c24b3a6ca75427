// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "scene/framing/Framing.h"

#include <QMenu>
#include <QWheelEvent>

// From where the picture is seen, in the program's window: a gesture back and forward again.

namespace limn {
namespace {

class CameraWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    ASSERT_TRUE(open(QStringLiteral("phantom:6")));
    setLayout(CompareLayout::single);
    ASSERT_TRUE(rest());
  }

  QAction& action(const char* name) const { return *window->findChild<QAction*>(QLatin1String(name)); }
  const Camera& camera() const { return scene().camera; }

  // Of the window, as the display sends events there; offsets from the picture's middle.
  QPoint inPicture(const QPoint& fromMiddle) {
    const QRectF picture = view().logicalRect(0);
    return view().mapTo(window.get(), picture.center().toPoint()) + fromMiddle;
  }

  void drag(const QPoint& from, const QPoint& by, Qt::MouseButton button = Qt::LeftButton,
            Qt::KeyboardModifiers keys = {}) {
    QWindow* handle = window->windowHandle();
    QTest::mousePress(handle, button, keys, inPicture(from));
    for (int step = 1; step <= 3; ++step)
      QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, keys, inPicture(from + step * by / 3));
    QTest::mouseRelease(handle, button, keys, inPicture(from + by));
    QCoreApplication::processEvents();
  }

  // A notch away from the user, at a time of its own.
  void turnWheel(quint64 timestampMs) {
    const QPointF middle = view().logicalRect(0).center();
    QWheelEvent wheel(middle, view().mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    wheel.setTimestamp(timestampMs);
    QCoreApplication::sendEvent(&view(), &wheel);
  }

  void goBack() { QTest::keyClick(window->windowHandle(), Qt::Key_Left, Qt::AltModifier); }
  void goForward() { QTest::keyClick(window->windowHandle(), Qt::Key_Right, Qt::AltModifier); }
};

TEST_F(CameraWindow, eachGestureIsOneStepBackAndForwardAndNoEdit) {
  EXPECT_FALSE(action("cameraBack").isEnabled());
  EXPECT_FALSE(action("cameraForward").isEnabled());
  view().setFocus();
  std::vector<Camera> places{camera()};
  const auto note = [&] {
    EXPECT_NE(camera(), places.back());
    places.push_back(camera());
  };
  drag({0, 0}, {60, 30});
  note();
  drag({0, 0}, {30, 12}, Qt::MiddleButton);
  note();
  drag({0, 0}, {0, -30}, Qt::RightButton);
  note();
  for (const quint64 ms : {5000, 5100, 5200})
    turnWheel(ms);
  note();
  QTest::keyClick(window->windowHandle(), Qt::Key_L);
  note();
  action("view-superior").trigger();
  note();
  action("orthographic").trigger();
  note();
  QTest::keyClick(window->windowHandle(), Qt::Key_R);
  note();
  ASSERT_EQ(places.size(), 9u);
  for (std::size_t step = places.size() - 1; step-- > 0;) {
    ASSERT_TRUE(action("cameraBack").isEnabled());
    goBack();
    EXPECT_EQ(camera(), places[step]) << step;
  }
  EXPECT_FALSE(action("cameraBack").isEnabled());
  for (std::size_t step = 1; step < places.size(); ++step) {
    ASSERT_TRUE(action("cameraForward").isEnabled());
    goForward();
    EXPECT_EQ(camera(), places[step]) << step;
  }
  EXPECT_FALSE(action("cameraForward").isEnabled());
  EXPECT_EQ(undo().count(), 0);
  EXPECT_TRUE(action("orthographic").isChecked());
  goBack();
  goBack();
  EXPECT_FALSE(action("orthographic").isChecked()) << "the menu follows";
}

TEST_F(CameraWindow, aPauseOfTheWheelBeginsAnotherStep) {
  const Camera first = camera();
  turnWheel(5000);
  turnWheel(5400);
  const Camera nearer = camera();
  turnWheel(9000);
  action("cameraBack").trigger();
  EXPECT_EQ(camera(), nearer);
  action("cameraBack").trigger();
  EXPECT_EQ(camera(), first);
}

TEST_F(CameraWindow, aDragThatIsCancelledLeavesNoStep) {
  view().setFocus();
  QWindow* handle = window->windowHandle();
  const Camera before = camera();
  QTest::mousePress(handle, Qt::LeftButton, {}, inPicture({0, 0}));
  QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, inPicture({40, 0}));
  ASSERT_NE(camera(), before);
  QTest::keyClick(handle, Qt::Key_Escape);
  QTest::mouseRelease(handle, Qt::LeftButton, {}, inPicture({40, 0}));
  EXPECT_EQ(camera(), before);
  EXPECT_FALSE(action("cameraBack").isEnabled());
}

TEST_F(CameraWindow, anEditStaysWhereTheCameraGoesBack) {
  drag({0, 0}, {60, 0});
  const TransferFunction faint = withOpacityScaled(scene().transferFunction, 0.5);
  session().setTransferFunction(faint, {nextGestureId(), QStringLiteral("faint")});
  action("cameraBack").trigger();
  EXPECT_EQ(scene().transferFunction, faint);
  EXPECT_EQ(undo().count(), 1);
  const Camera there = camera();
  undo().undo();
  EXPECT_EQ(camera(), there) << "nor does undo move the camera";
  EXPECT_TRUE(action("cameraForward").isEnabled());
}

TEST_F(CameraWindow, aCameraOfAnotherShapeOfThePictureIsFittedToThisOne) {
  view().setFocus();
  QTest::keyClick(window->windowHandle(), Qt::Key_L);
  ASSERT_TRUE(rest());
  QTest::keyClick(window->windowHandle(), Qt::Key_A);
  ASSERT_TRUE(rest());
  const double before = view().pictureAspect();
  setLayout(CompareLayout::sideBySide);
  ASSERT_TRUE(rest());
  ASSERT_NE(view().pictureAspect(), before);
  goBack();
  EXPECT_TRUE(isFramed(camera(), scene().volume->grid(), visibleBox(scene()), view().pictureAspect()))
      << "what was framed is framed";
}

TEST_F(CameraWindow, anotherVolumeBeginsAnew) {
  drag({0, 0}, {60, 0});
  action("cameraBack").trigger();
  drag({0, 0}, {60, 0});
  ASSERT_TRUE(action("cameraBack").isEnabled());
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  EXPECT_FALSE(action("cameraBack").isEnabled());
  EXPECT_FALSE(action("cameraForward").isEnabled());
}

} // namespace
} // namespace limn
