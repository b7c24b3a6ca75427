// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "planes/GreyWindows.h"
#include "support/JudgedTime.h"
#include "support/TestData.h"
#include "widgets/planes/PlaneDeck.h"
#include "widgets/planes/PlaneView.h"
#include "widgets/view/gestures/ViewInput.h"
#include "widgets/view/overlay/ViewGeometry.h"

#include <QWheelEvent>

#include <chrono>

// Slices beside the picture, in the program's window.

namespace limn {
namespace {

class PlanesWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    window->resize(1280, 800);
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:4")));
  }

  const PlaneSettings& planes() const { return session().planes(); }
  PlaneView& plane(PatientPlane which) const { return *window->findChild<PlaneDeck*>()->view(which); }

  void choose(const char* layout) {
    window->findChild<QAction*>(QStringLiteral("planes-") + QLatin1String(layout))->trigger();
    QCoreApplication::processEvents();
  }

  QString checkedLayout() const {
    for (const QAction* one : window->findChildren<QAction*>())
      if (one->isChecked() && one->objectName().startsWith(QStringLiteral("planes-")))
        return one->objectName().mid(7);
    return {};
  }

  /// The place in the window of a place of the world in a slice.
  QPoint inWindow(const PlaneView& view, const glm::dvec3& worldMm) const {
    return view.mapTo(window.get(), pointOf(view.frame(), worldMm)).toPoint();
  }

  std::optional<double> markedValue() const {
    const std::optional<ValueMark> mark = curves().valueEditor()->canvas()->mark();
    return mark ? std::optional(mark->value) : std::nullopt;
  }

  double valueAtCrosshair() const {
    const Volume& volume = *scene().volume;
    return valueAt(volume, worldToIndex(volume.grid(), *planes().crosshairMm));
  }
};

TEST_F(PlanesWindow, layoutsAreChosenByActionsAndShowTheirSlices) {
  EXPECT_EQ(checkedLayout(), QStringLiteral("picture"));
  for (const PatientPlane each : patientPlanes)
    EXPECT_FALSE(plane(each).isVisible());
  const QSize alone = view().size();
  choose("picture_and_three");
  EXPECT_EQ(checkedLayout(), QStringLiteral("picture_and_three"));
  for (const PatientPlane each : patientPlanes)
    EXPECT_TRUE(plane(each).isVisible());
  EXPECT_LT(view().width(), alone.width() * 6 / 10);
  EXPECT_TRUE(view().isVisible());
  choose("one_large");
  EXPECT_GT(plane(PatientPlane::axial).width(), 2 * plane(PatientPlane::coronal).width());
  choose("picture");
  EXPECT_EQ(view().size(), alone);
  EXPECT_EQ(undo().count(), 0) << "a layout is no edit";
}

TEST_F(PlanesWindow, theToolBarHasTheLayouts) {
  auto* bar = window->findChild<QToolBar*>(QStringLiteral("toolBar"));
  QWidget* button =
      bar->widgetForAction(window->findChild<QAction*>(QStringLiteral("planes-picture_and_three")));
  ASSERT_NE(button, nullptr);
  ASSERT_TRUE(button->isVisible());
  QTest::mouseClick(button, Qt::LeftButton);
  EXPECT_EQ(planes().layout, PlaneLayout::pictureAndThree);
}

TEST_F(PlanesWindow, aClickInASliceShowsItsPlaceInTheOthersThePictureAndTheCurve) {
  choose("picture_and_three");
  ASSERT_TRUE(rest());
  const PlaneView& axial = plane(PatientPlane::axial);
  const glm::dvec3 middle = crosshairOf(axial.content());
  const glm::dvec3 place(-40.0, 30.0, middle.z);
  const QImage before = view().grab().toImage();
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, inWindow(axial, place));
  ASSERT_TRUE(test::waitUntil([&] { return planes().crosshairMm.has_value(); }));
  EXPECT_LT(glm::length(*planes().crosshairMm - place), mmPerLogicalPixel(axial.frame()));
  EXPECT_EQ(plane(PatientPlane::sagittal).frame().grid.originMm.x, planes().crosshairMm->x);
  EXPECT_EQ(plane(PatientPlane::coronal).frame().grid.originMm.y, planes().crosshairMm->y);
  // One value: under the crosshair, on the curve, told by the slice.
  ASSERT_TRUE(markedValue());
  EXPECT_EQ(*markedValue(), valueAtCrosshair());
  // Its mark is where the camera sees that place.
  const auto marked = pixelOf(viewProjection(scene().camera, QRectF(view().rect())), *planes().crosshairMm);
  ASSERT_TRUE(marked);
  const QColor mark(77, 163, 255);
  const auto isMarked = [&](const QPointF& at) {
    const QImage picture = view().grab().toImage();
    for (int x = -7; x <= 7; ++x)
      for (int y = -7; y <= 7; ++y) {
        const QColor color = picture.pixelColor(at.toPoint() + QPoint(x, y));
        if (std::abs(color.red() - mark.red()) + std::abs(color.green() - mark.green()) +
                std::abs(color.blue() - mark.blue()) <
            60)
          return true;
      }
    return false;
  };
  EXPECT_TRUE(test::waitUntil([&] { return isMarked(*marked); }));
  choose("picture");
  EXPECT_FALSE(markedValue()) << "without slices nothing is marked";
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(PlanesWindow, shiftClickInThePictureLeadsTheCrosshairThere) {
  choose("picture_and_three");
  ASSERT_TRUE(rest());
  const QPoint at = view().mapTo(window.get(), view().rect().center());
  std::optional<Probe> probed;
  QObject::connect(&view().input(), &ViewInput::probed, window.get(), [&](const std::optional<Probe>& probe) {
    if (probe)
      probed = probe;
  });
  QWindow* handle = window->windowHandle();
  QTest::mouseMove(handle, at - QPoint(5, 5));
  QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, Qt::ShiftModifier, at);
  ASSERT_TRUE(test::waitUntil([&] { return probed.has_value(); }));
  EXPECT_EQ(markedValue(), probed->value);
  QTest::mouseClick(handle, Qt::LeftButton, Qt::ShiftModifier, at);
  ASSERT_TRUE(test::waitUntil([&] { return planes().crosshairMm.has_value(); }));
  EXPECT_EQ(*planes().crosshairMm, probed->positionMm) << "inside the volume it stays as it is";
  EXPECT_EQ(curves().valueEditor()->canvas()->pinnedValue(), probed->value);
  EXPECT_NEAR(valueAtCrosshair(), probed->value, 1e-9) << "probe and crosshair tell one value";
}

TEST_F(PlanesWindow, theWheelLeadsThroughSlicesAndNoCameraMoves) {
  choose("one_large");
  const PlaneView& axial = plane(PatientPlane::axial);
  const Camera camera = scene().camera;
  const double before = crosshairOf(axial.content()).z;
  const QPointF at(axial.width() / 2.0, axial.height() / 2.0);
  QWheelEvent event(at, axial.mapToGlobal(at), {}, {0, 240}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&plane(PatientPlane::axial), &event);
  EXPECT_EQ(planes().crosshairMm->z, before + 8.0) << "two slices of 4 mm";
  EXPECT_EQ(scene().camera, camera);
}

TEST_F(PlanesWindow, theRightButtonDragsTheWindowAndTheMiddleOnePans) {
  choose("picture_and_three");
  const PlaneView& coronal = plane(PatientPlane::coronal);
  QWindow* handle = window->windowHandle();
  const QPoint from = coronal.mapTo(window.get(), coronal.rect().center());
  QTest::mousePress(handle, Qt::RightButton, {}, from);
  QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, from + QPoint(40, -20));
  QTest::mouseRelease(handle, Qt::RightButton, {}, from + QPoint(40, -20));
  ASSERT_TRUE(test::waitUntil([&] { return planes().window.has_value(); }));
  EXPECT_GT(planes().window->width, windowOf(TissueWindow::softTissue).width);
  EXPECT_GT(planes().window->centre, windowOf(TissueWindow::softTissue).centre);
  const PlaneGrid before = coronal.frame().grid;
  QTest::mousePress(handle, Qt::MiddleButton, {}, from);
  QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, from + QPoint(30, 10));
  QTest::mouseRelease(handle, Qt::MiddleButton, {}, from + QPoint(30, 10));
  EXPECT_TRUE(test::waitUntil([&] { return coronal.frame().grid.originMm != before.originMm; }));
  EXPECT_FALSE(planes().crosshairMm);
  EXPECT_EQ(undo().count(), 0);
}

TEST_F(PlanesWindow, aDoubleClickMakesASliceLargeAndBack) {
  choose("picture_and_three");
  PlaneView& sagittal = plane(PatientPlane::sagittal);
  QTest::mouseDClick(window->windowHandle(), Qt::LeftButton, {},
                     sagittal.mapTo(window.get(), sagittal.rect().center()));
  ASSERT_TRUE(test::waitUntil([&] { return planes().layout == PlaneLayout::oneLarge; }));
  EXPECT_EQ(planes().large, PatientPlane::sagittal);
  EXPECT_EQ(checkedLayout(), QStringLiteral("one_large"));
}

TEST_F(PlanesWindow, theLayoutAndWhatSlicesShowAreKeptInSessions) {
  choose("picture_and_three");
  PlaneSettings settings = planes();
  settings.crosshairMm = glm::dvec3(10.0, -20.0, 30.0);
  settings.window = windowOf(TissueWindow::bone);
  settings.isTinted = true;
  settings.slab = {Slab::Mode::maximum, 12.0};
  session().setPlanes(settings);
  typeName(pathTo("with_slices.json"));
  window->findChild<QAction*>(QStringLiteral("saveSession"))->trigger();
  ASSERT_TRUE(test::waitUntil([&] { return QFile::exists(pathTo("with_slices.json")); }));
  choose("picture");
  ASSERT_TRUE(open(pathTo("with_slices.json")));
  EXPECT_EQ(planes(), settings);
  EXPECT_EQ(checkedLayout(), QStringLiteral("picture_and_three"));
  EXPECT_TRUE(plane(PatientPlane::axial).isVisible());
}

TEST_F(PlanesWindow, anotherVolumeKeepsTheLayoutAndForgetsThePlaces) {
  choose("picture_and_three");
  PlaneSettings settings = planes();
  settings.crosshairMm = glm::dvec3(10.0, -20.0, 30.0);
  settings.window = GreyWindow{1.0, 2.0};
  session().setPlanes(settings);
  ASSERT_TRUE(open(QStringLiteral("phantom:5")));
  EXPECT_EQ(planes().layout, PlaneLayout::pictureAndThree);
  EXPECT_FALSE(planes().crosshairMm);
  EXPECT_FALSE(planes().window);
  EXPECT_EQ(windowOf(plane(PatientPlane::axial).content()), windowOf(TissueWindow::softTissue));
}

TEST_F(PlanesWindow, withoutAVolumeThePictureHasAllOfThePlace) {
  const QSize alone = view().size();
  choose("picture_and_three");
  window->findChild<QAction*>(QStringLiteral("closeVolume"))->trigger();
  EXPECT_EQ(view().size(), alone);
  EXPECT_FALSE(plane(PatientPlane::axial).isVisible());
  EXPECT_FALSE(markedValue());
  ASSERT_TRUE(open(QStringLiteral("phantom:5")));
  EXPECT_TRUE(plane(PatientPlane::axial).isVisible()) << "the layout is kept";
}

TEST_F(PlanesWindow, aCurveThatIsEditedTintsTheSlicesAtOnce) {
  choose("picture_and_three");
  PlaneSettings settings = planes();
  settings.isTinted = true;
  session().setPlanes(settings);
  PlaneView& axial = plane(PatientPlane::axial);
  const QImage before = axial.grab().toImage();
  const int readings = axial.readings();
  session().setTransferFunction({1.0, {{0.0, {0.0, 1.0, 0.0}, 1.0}, {3000.0, {0.0, 1.0, 0.0}, 1.0}}},
                                {nextGestureId(), "green"});
  EXPECT_NE(axial.grab().toImage(), before);
  EXPECT_EQ(axial.readings(), readings) << "no voxel is read for it";
}

// From a move of the pointer to three slices on the screen, of a volume as large as a chest.
TEST(PlanesFollow, thePointerWithin16ms) {
  const bool isBench = std::getenv("LIMN_BENCH") != nullptr;
  const glm::ivec3 dims(512, 512, isBench ? 300 : 12);
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = {0.7, 0.7, 1.0};
  std::vector<std::int16_t> stored(static_cast<std::size_t>(dims.x) * dims.y * dims.z);
  for (std::size_t i = 0; i < stored.size(); ++i)
    stored[i] = static_cast<std::int16_t>(i % 1713 * 7 % 4000);
  PlaneContent content;
  content.volume = std::make_shared<const Volume>(grid, std::move(stored), Rescale{1.0, -1024.0},
                                                  std::nullopt, VolumeInfo{});
  content.firstWindow = windowOf(TissueWindow::softTissue);
  content.settings.layout = PlaneLayout::pictureAndThree;
  PlaneDeck deck(*new QWidget);
  deck.resize(1320, 900);
  QObject::connect(&deck, &PlaneDeck::settingsEdited, [&](const PlaneSettings& settings) {
    content.settings = settings;
    deck.setContent(content);
  });
  deck.setContent(content);
  deck.show();
  ASSERT_TRUE(test::waitUntilExposed(deck));
  PlaneView& axial = *deck.view(PatientPlane::axial);
  const QPoint from = axial.mapTo(&deck, axial.rect().center());
  QWindow* handle = deck.windowHandle();
  QTest::mousePress(handle, Qt::LeftButton, {}, from);
  double shortest = 1e9;
  for (int step = 1; step <= 15; ++step) {
    const int before = axial.readings() + deck.view(PatientPlane::coronal)->readings();
    const auto start = std::chrono::steady_clock::now();
    QTest::mouseEvent(QTest::MouseMove, handle, Qt::NoButton, {}, from + QPoint(3 * step, 2 * step), 0);
    ASSERT_TRUE(test::waitUntil(
        [&] { return axial.readings() + deck.view(PatientPlane::coronal)->readings() > before; }));
    shortest =
        std::min(shortest,
                 std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  QTest::mouseRelease(handle, Qt::LeftButton, {}, from + QPoint(45, 30));
  test::judgeMs("from the pointer to the slices", shortest, 16.0);
}

} // namespace
} // namespace limn
