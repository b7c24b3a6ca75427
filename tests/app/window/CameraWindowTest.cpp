// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "reference/ProfileAlong.h"
#include "scene/framing/Framing.h"
#include "scene/view/PlaneSettings.h"
#include "widgets/view/gestures/ViewInput.h"
#include "widgets/view/overlay/Overlay.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QMenu>
#include <QStatusBar>
#include <QWheelEvent>

// From where the picture is seen, in the program's window: a gesture back and forward again, turns about what
// was pointed at, and what a right click offers.

namespace limn {
namespace {

class CameraWindow : public test::OpenGlWindow {
protected:
  void SetUp() override {
    OpenGlWindow::SetUp();
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:6")));
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

  void click(const QPoint& at, Qt::MouseButton button, Qt::KeyboardModifiers keys = {}) {
    QTest::mouseClick(window->windowHandle(), button, keys, inPicture(at));
    QCoreApplication::processEvents();
  }

  ViewGeometry geometry() { return view().order().geometry; }
  // Of the view, logical pixels.
  QPointF inView(const QPoint& fromMiddle) { return view().mapFrom(window.get(), inPicture(fromMiddle)); }

  // Where half of the light of the ray below a point is gathered, by the definition itself.
  std::optional<glm::dvec3> seenAt(const QPoint& fromMiddle) {
    const std::optional<Ray> ray = rayUnder(geometry(), camera(), inView(fromMiddle));
    const auto profile = profileAlong(view().sceneOfSide(0), view().input().scaleOfSide(0), ray.value());
    const auto depth = profile ? halfLightDepth(*profile) : std::nullopt;
    return depth ? std::optional(placeAt(*profile, *depth)) : std::nullopt;
  }
  std::optional<QPointF> pixelOfPlace(const glm::dvec3& place) {
    return pixelOf(viewProjection(camera(), view().logicalRect(0)), place);
  }

  QMenu* menu() { return view().findChild<QMenu*>(QStringLiteral("pictureMenu")); }
  QAction& entry(const char* name) { return *menu()->findChild<QAction*>(QLatin1String(name)); }
  void closeMenu() {
    menu()->close();
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }
  QString said() const { return window->statusBar()->currentMessage(); }

  // Beside the body, where nothing is seen.
  QPoint corner() {
    const QSizeF size = view().logicalRect(0).size();
    return QPoint(static_cast<int>(size.width() / 2.0) - 3, 0);
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
  EXPECT_TRUE(isFramed(camera(), scene().volume->grid(), visibleVoxels(scene()), view().pictureAspect()))
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

TEST_F(CameraWindow, shiftAndTheMiddleButtonHaveTurnsGoAboutWhatIsSeenThere) {
  const QPoint at(35, -25);
  const std::optional<glm::dvec3> place = seenAt(at);
  ASSERT_TRUE(place) << "something is seen there";
  click(at, Qt::MiddleButton, Qt::ShiftModifier);
  ASSERT_TRUE(view().turnsAbout());
  EXPECT_LT(glm::length(*view().turnsAbout() - *place), 1e-9);
  EXPECT_TRUE(said().contains(QStringLiteral("Turns go about"))) << said().toStdString();
  const Camera before = camera();
  const QPointF was = pixelOfPlace(*place).value();
  drag({0, 0}, {60, 24});
  const double turned = glm::dot(basisOf(camera()).forward, basisOf(before).forward);
  EXPECT_LT(turned, 0.99);
  const QPointF is = pixelOfPlace(*place).value();
  EXPECT_NEAR(is.x(), was.x(), 1e-6); // rounding: millionths of a pixel
  EXPECT_NEAR(is.y(), was.y(), 1e-6);
  EXPECT_NEAR(is.x(), inView(at).x(), 1.0) << "below the pointer, to the pixel that was picked";
  view().setFocus();
  QTest::keyClick(window->windowHandle(), Qt::Key_Left);
  EXPECT_NEAR(pixelOfPlace(*place)->x(), was.x(), 1e-6) << "arrow keys turn about it, too";
  QTest::keyClick(window->windowHandle(), Qt::Key_R);
  EXPECT_FALSE(view().turnsAbout()) << "reset ends it";
  const glm::dvec3 target = camera().target;
  drag({0, 0}, {60, 24});
  EXPECT_EQ(camera().target, target);
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(CameraWindow, theScaleHoldsAtTheTurningPointWhateverLiesInTheMiddle) {
  const auto bar = [&] { return overlayOf({view().order(), view().pictureState()}).scale; };
  ASSERT_TRUE(bar());
  EXPECT_EQ(bar()->text, QStringLiteral("%1 mm at the pivot").arg(bar()->bar.lengthMm));
  const double atTarget = bar()->bar.pixels / bar()->bar.lengthMm;
  drag({0, 0}, {60, 24}, Qt::MiddleButton);
  ASSERT_TRUE(rest());
  // Rounding: the distance to the target is kept to thousandths of a micrometre.
  EXPECT_NEAR(bar()->bar.pixels / bar()->bar.lengthMm, atTarget, 1e-9 * atTarget) << "moving changes nothing";
  const glm::dvec3 half = 0.5 * (camera().position + camera().target);
  view().setTurnsAbout(half);
  EXPECT_NEAR(bar()->bar.pixels / bar()->bar.lengthMm, 2.0 * atTarget, 1e-9 * atTarget) << "half as far";
  QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, {},
                    view().mapTo(window.get(), bar()->plate.center().toPoint()));
  EXPECT_TRUE(view().toolTip().contains(QStringLiteral("Orthographic"))) << view().toolTip().toStdString();
}

TEST_F(CameraWindow, theCentreOfATurnIsMarkedWhileItLasts) {
  const auto centres = [&] { return overlayOf({view().order(), view().pictureState()}).centres; };
  const QPoint at(35, -25);
  click(at, Qt::MiddleButton, Qt::ShiftModifier);
  ASSERT_TRUE(view().turnsAbout());
  EXPECT_TRUE(centres().empty());
  QWindow* handle = window->windowHandle();
  QTest::mousePress(handle, Qt::LeftButton, {}, inPicture({0, 0}));
  EXPECT_TRUE(centres().empty()) << "nothing turns yet";
  QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, inPicture({40, 0}));
  ASSERT_EQ(centres().size(), 1u);
  EXPECT_NEAR(centres()[0].x(), pixelOfPlace(*view().turnsAbout())->x(), 1e-9);
  QTest::mouseRelease(handle, Qt::LeftButton, {}, inPicture({40, 0}));
  EXPECT_TRUE(centres().empty());
}

TEST_F(CameraWindow, whereNothingIsSeenTurnsGoOnAsBeforeAndThatIsSaid) {
  ASSERT_FALSE(seenAt(corner()));
  click({35, -25}, Qt::MiddleButton, Qt::ShiftModifier);
  const auto before = view().turnsAbout();
  ASSERT_TRUE(before);
  click(corner(), Qt::MiddleButton, Qt::ShiftModifier);
  EXPECT_EQ(view().turnsAbout(), before);
  EXPECT_EQ(said(), QStringLiteral("Nothing is seen there."));
  drag({0, 0}, {30, 0}, Qt::MiddleButton, Qt::ShiftModifier);
  EXPECT_EQ(view().turnsAbout(), before) << "a drag still moves the picture";
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  EXPECT_FALSE(view().turnsAbout()) << "another volume";
}

TEST_F(CameraWindow, aRightClickOffersWhatCanBeDoneThereAndADragZoomsStill) {
  const Camera first = camera();
  drag({35, -25}, {0, -40}, Qt::RightButton);
  EXPECT_EQ(menu(), nullptr);
  EXPECT_NE(camera(), first);
  action("cameraBack").trigger();
  const std::optional<glm::dvec3> place = seenAt({35, -25});
  click({35, -25}, Qt::RightButton);
  ASSERT_NE(menu(), nullptr);
  EXPECT_EQ(camera(), first) << "a click moves nothing";
  EXPECT_TRUE(entry("turnAbout").isEnabled());
  EXPECT_FALSE(entry("turnAboutMiddle").isEnabled());
  EXPECT_FALSE(entry("goInSlices").isEnabled());
  EXPECT_TRUE(entry("goInSlices").toolTip().contains(QStringLiteral("Slices"))) << "which says why";
  EXPECT_TRUE(menu()->actions().contains(&action("resetCamera")));
  entry("turnAbout").trigger();
  closeMenu();
  ASSERT_TRUE(view().turnsAbout());
  EXPECT_LT(glm::length(*view().turnsAbout() - *place), 1e-9);
  click({0, 0}, Qt::RightButton);
  ASSERT_NE(menu(), nullptr);
  entry("turnAboutMiddle").trigger();
  closeMenu();
  EXPECT_FALSE(view().turnsAbout());
}

TEST_F(CameraWindow, itsValueIsCopiedAndTheCrosshairGoesThere) {
  action("planes-picture_and_three").trigger();
  ASSERT_TRUE(rest());
  std::optional<Probe> probed;
  QObject::connect(&view().input(), &ViewInput::probed, window.get(), [&](const std::optional<Probe>& now) {
    if (now)
      probed = now;
  });
  const QPoint at(10, -10);
  QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, Qt::ShiftModifier, inPicture(at));
  ASSERT_TRUE(test::waitUntil([&] { return probed.has_value(); })) << "what Shift tells there";
  click(at, Qt::RightButton);
  ASSERT_NE(menu(), nullptr);
  const QString value = readingText(probed->value, *scene().volume);
  EXPECT_TRUE(entry("copyValue").text().endsWith(value)) << entry("copyValue").text().toStdString();
  entry("copyValue").trigger();
  EXPECT_EQ(QApplication::clipboard()->text(), value);
  EXPECT_TRUE(value.endsWith(QString::fromStdString(scene().volume->info().unit)));
  ASSERT_TRUE(entry("goInSlices").isEnabled());
  entry("goInSlices").trigger();
  closeMenu();
  ASSERT_TRUE(session().planes().crosshairMm);
  EXPECT_LT(glm::length(*session().planes().crosshairMm - probed->positionMm), 1e-9);
}

TEST_F(CameraWindow, besideTheBodyTheMenuSaysThatNothingIsSeen) {
  view().setFocus();
  click(corner(), Qt::RightButton);
  ASSERT_NE(menu(), nullptr);
  for (const char* name : {"turnAbout", "copyValue"}) {
    EXPECT_FALSE(entry(name).isEnabled()) << name;
    EXPECT_EQ(entry(name).toolTip(), QStringLiteral("Nothing is seen there.")) << name;
  }
  EXPECT_TRUE(menu()->toolTipsVisible());
  closeMenu();
}

TEST_F(CameraWindow, theMenuKeyOffersItInTheMiddleOfThePicture) {
  QContextMenuEvent key(QContextMenuEvent::Keyboard, view().rect().center(),
                        view().mapToGlobal(view().rect().center()));
  QCoreApplication::sendEvent(&view(), &key);
  ASSERT_NE(menu(), nullptr);
  closeMenu();
}

} // namespace
} // namespace limn
