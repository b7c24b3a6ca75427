// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "reference/ProfileAlong.h"
#include "widgets/ray/RayPanel.h"
#include "widgets/view/gestures/ViewInput.h"

#include <QDockWidget>
#include <QPushButton>

// What one ray of the picture meets, in the program's window.

namespace limn {
namespace {

class RayWindow : public test::WindowHarness {
protected:
  void SetUp() override {
    WindowHarness::SetUp();
    window->resize(1280, 800);
    ASSERT_TRUE(openAlone(QStringLiteral("phantom:4")));
    window->findChild<QAction*>(QStringLiteral("planes-picture_and_three"))->trigger();
  }

  RayPanel& panel() const { return *window->findChild<RayPanel*>(); }
  ProfileChart& chart() const { return *panel().chart(); }
  QAction& toggle() const {
    return *window->findChild<QDockWidget*>(QStringLiteral("rayDock"))->toggleViewAction();
  }
  QString summary() const { return panel().findChild<QLabel*>(QStringLiteral("raySummary"))->text(); }

  void showPanel() {
    toggle().trigger();
    ASSERT_TRUE(test::waitUntil([this] { return panel().isVisible(); }));
    ASSERT_TRUE(rest());
  }

  QPoint inWindow(const QWidget& part, const QPointF& at) const {
    return part.mapTo(window.get(), at).toPoint();
  }

  // Moves the pointer there with Shift held.
  void probe(const QPoint& at) {
    QTest::mouseMove(window->windowHandle(), at - QPoint(5, 5));
    QTest::mouseEvent(QTest::MouseMove, window->windowHandle(), Qt::NoButton, Qt::ShiftModifier, at);
  }
};

TEST_F(RayWindow, thePanelIsAwayUntilItIsAskedFor) {
  ASSERT_TRUE(rest());
  EXPECT_FALSE(panel().isVisible());
  showPanel();
  EXPECT_TRUE(summary().contains(QStringLiteral("Half of the light")));
  ASSERT_TRUE(chart().profile()) << "the ray through the crosshair";
  toggle().trigger();
  EXPECT_FALSE(panel().isVisible());
}

TEST_F(RayWindow, shiftOverThePictureReadsTheRayBelowThePointerAndItStays) {
  showPanel();
  const QPoint middle = inWindow(view(), QRectF(view().rect()).center());
  std::optional<Probe> probed;
  QObject::connect(&view().input(), &ViewInput::probed, window.get(), [&](const std::optional<Probe>& now) {
    if (now)
      probed = now;
  });
  std::optional<Ray> read;
  QObject::connect(&view().input(), &ViewInput::rayRead, window.get(), [&](const Ray& ray) { read = ray; });
  probe(middle + QPoint(10, -20));
  ASSERT_TRUE(test::waitUntil([&] { return read.has_value() && probed.has_value(); }));
  const RayProfile shown = chart().profile().value();
  EXPECT_LT(glm::length(shown.direction - read->direction), 1e-12);
  const auto expected = profileAlong(scene(), view().input().scaleOfSide(0), *read);
  ASSERT_TRUE(expected);
  EXPECT_NEAR(shown.alpha, expected->alpha, 1e-9);
  // Probe and profile tell one value: the probe's place lies on the ray.
  const double depth = glm::dot(probed->positionMm - shown.entryMm, shown.direction);
  EXPECT_LT(glm::length(placeAt(shown, depth) - probed->positionMm), 1e-6);
  const Volume& volume = *scene().volume;
  const RayProfile::Sample& sample = sampleAt(shown, depth);
  EXPECT_LE(std::abs(sample.depthMm - depth), sample.lengthMm / 2.0 + 1e-9);
  EXPECT_NEAR(valueAt(volume, worldToIndex(volume.grid(), placeAt(shown, sample.depthMm))), sample.value,
              1e-6);
  EXPECT_NEAR(valueAt(volume, worldToIndex(volume.grid(), placeAt(shown, depth))), probed->value, 1e-6);
  QTest::mouseMove(window->windowHandle(), inWindow(chart(), QPointF(20, 20)));
  QCoreApplication::processEvents();
  ASSERT_TRUE(chart().profile());
  EXPECT_EQ(chart().profile()->entryMm, shown.entryMm) << "on the way to the chart it stays";
}

TEST_F(RayWindow, itFollowsTheCrosshairTheCurveAndTheCamera) {
  showPanel();
  PlaneSettings planes = session().planes();
  planes.crosshairMm = glm::dvec3(20.0, 0.0, 10.0);
  session().setPlanes(planes);
  const RayProfile first = chart().profile().value();
  const double beside = glm::length(glm::cross(*planes.crosshairMm - first.entryMm, first.direction));
  EXPECT_LT(beside, 1e-9) << "it goes through the crosshair";
  TransferFunction faint = withOpacityScaled(scene().transferFunction, 0.01);
  session().setTransferFunction(faint, {nextGestureId(), "faint"});
  EXPECT_LT(chart().profile()->alpha, first.alpha);
  session().setCamera(orbited(scene().camera, 0.5, 0.0));
  const RayProfile turned = chart().profile().value();
  EXPECT_GT(glm::length(turned.direction - first.direction), 0.1);
  EXPECT_LT(glm::length(glm::cross(*planes.crosshairMm - turned.entryMm, turned.direction)), 1e-9);
  EXPECT_EQ(undo().count(), 1) << "reading is no edit";
}

TEST_F(RayWindow, aClickInTheChartLeadsTheCrosshairThere) {
  showPanel();
  const double depth = chart().profile()->lengthMm / 3.0;
  const QPointF at(xOfValue(chart().depths(), depth), chart().height() / 2.0);
  const RayProfile profile = *chart().profile();
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, inWindow(chart(), at));
  ASSERT_TRUE(test::waitUntil([&] { return session().planes().crosshairMm.has_value(); }));
  const double pixel = valuePerPixel(chart().depths());
  EXPECT_LT(glm::length(*session().planes().crosshairMm - placeAt(profile, depth)), pixel);
  const Volume& volume = *scene().volume;
  EXPECT_EQ(curves().valueEditor()->canvas()->pinnedValue(),
            valueAt(volume, worldToIndex(volume.grid(), *session().planes().crosshairMm)));
}

TEST_F(RayWindow, keysReadAndChooseADepthAndTheButtonGoesToTheHalf) {
  showPanel();
  const RayProfile profile = *chart().profile();
  ASSERT_TRUE(halfLightDepth(profile));
  chart().setFocus();
  QTest::keyClick(window->windowHandle(), Qt::Key_H);
  ASSERT_TRUE(chart().cursor());
  EXPECT_NEAR(*chart().cursor(), *halfLightDepth(profile), 1e-9);
  QTest::keyClick(window->windowHandle(), Qt::Key_Right, Qt::ShiftModifier);
  EXPECT_NEAR(*chart().cursor(), *halfLightDepth(profile) + 10.0 * valuePerPixel(chart().depths()), 1e-9);
  QTest::keyClick(window->windowHandle(), Qt::Key_Return);
  ASSERT_TRUE(session().planes().crosshairMm);
  EXPECT_LT(glm::length(*session().planes().crosshairMm - placeAt(profile, *chart().cursor())), 1e-9);
  auto* button = panel().findChild<QPushButton*>(QStringLiteral("goToHalf"));
  const QPointF middle = QRectF(button->rect()).center();
  QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, inWindow(*button, middle));
  EXPECT_LT(glm::length(*session().planes().crosshairMm - placeAt(profile, *halfLightDepth(profile))), 1e-9);
}

TEST_F(RayWindow, withoutAVolumeItSaysHowARayIsRead) {
  showPanel();
  window->findChild<QAction*>(QStringLiteral("closeVolume"))->trigger();
  EXPECT_FALSE(chart().profile());
  EXPECT_TRUE(summary().contains(QStringLiteral("Shift")));
}

} // namespace
} // namespace limn
