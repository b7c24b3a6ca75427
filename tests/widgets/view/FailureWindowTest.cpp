// SPDX-License-Identifier: GPL-3.0-or-later
#include "ViewHost.h"
#include "reference/ReferenceIntegrator.h"
#include "support/BrokenDriver.h"
#include "support/ReferenceEngine.h"
#include "widgets/view/panels/PanelStack.h"
#include "widgets/view/pictures/PictureScreen.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLabel>
#include <QOpenGLContext>
#include <QPushButton>
#include <QSignalSpy>

// Drivers that lose, refuse or forget, in a real window.

namespace limn {
namespace {

using test::ViewHost;

QImage drawnByReference(const Scene& scene, const QImage& shown) {
  const glm::ivec2 size(shown.width(), shown.height());
  return overBackground(toImage(renderReference(scene, size, 1)), scene.image.background);
}

// A view at rest whose processor can draw.
struct RestingHost : ViewHost {
  RestingHost() : ViewHost({400, 240}, [] { return test::makeReferenceEngine(1); }) { showPhantom(12.0); }
  bool restOnProcessor() {
    return test::waitUntil([this] { return drawsOnProcessor() && view.pictureState().resting; });
  }
  const FailureBar& bar() { return *view.findChild<FailureBar*>(); }
};

TEST(DriverFailure, afterAResetTheContextIsMadeAnewAndThePictureIsTheSame) {
  RestingHost host;
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  const std::optional<Image> before = host.view.restingImage(0);
  QSignalSpy restored(&host.view, &CompareView::graphicsRestored);
  // The new context knows nothing of the reset.
  auto reset = std::make_unique<test::ResetDriver>();
  bool isMadeAnew = false;
  QObject::connect(host.canvas().context(), &QOpenGLContext::aboutToBeDestroyed, &host.view, [&] {
    isMadeAnew = true;
    reset.reset();
  });
  host.scene.transferFunction.points[2].opacity = 0.4;
  host.view.setScene(host.scene);
  ASSERT_TRUE(test::waitUntil([&] { return restored.count() == 1; }));
  EXPECT_TRUE(isMadeAnew);
  EXPECT_TRUE(host.errors.empty());
  host.scene.transferFunction.points[2].opacity = 0.5;
  host.view.setScene(host.scene);
  ASSERT_TRUE(host.rest());
  EXPECT_EQ(host.view.restingImage(0), before);
}

// A driver that forgets: the programs of the ray caster, which alone know of rays, vanish under its hands.
TEST(DriverFailure, whatTheDriverForgotIsMadeAnew) {
  RestingHost host;
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  const std::optional<Image> before = host.view.restingImage(0);
  QSignalSpy restored(&host.view, &CompareView::graphicsRestored);
  host.canvas().makeCurrent();
  test::forgetRayCasterPrograms();
  host.canvas().doneCurrent();
  host.scene.transferFunction.points[2].opacity = 0.4;
  host.view.setScene(host.scene);
  ASSERT_TRUE(test::waitUntil([&] { return restored.count() == 1; }));
  host.scene.transferFunction.points[2].opacity = 0.5;
  host.view.setScene(host.scene);
  ASSERT_TRUE(host.rest());
  EXPECT_EQ(host.view.restingImage(0), before);
  EXPECT_TRUE(host.errors.empty());
}

TEST(DriverFailure, whereEveryShaderIsRefusedTheProcessorDrawsAndSaysWhy) {
  RestingHost host;
  auto refused = std::make_unique<test::BrokenShaders>();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.restOnProcessor());
  ASSERT_EQ(host.errors.size(), 1u);
  EXPECT_EQ(host.view.pictureState().engine, Engine::cpu);
  EXPECT_EQ(host.view.pictureState().engineReason, host.errors[0]);
  EXPECT_TRUE(host.bar().isVisible());
  EXPECT_TRUE(
      host.view.findChild<QLabel*>(QStringLiteral("failureReason"))->text().startsWith(host.errors[0]));

  // The picture is the engine's, bit for bit, in all pixels above the bar.
  const QImage shown = host.view.currentPicture(0);
  EXPECT_EQ(shown.height(), host.bar().y());
  EXPECT_EQ(shown, drawnByReference(host.scene, shown));

  // What the driver wrote can be copied.
  QTest::mouseClick(host.view.findChild<QPushButton*>(QStringLiteral("copyFailure")), Qt::LeftButton);
  EXPECT_TRUE(QGuiApplication::clipboard()->text().contains(QStringLiteral("a line of a test")));

  // Drags reach the picture, and the driver's recovery is taken up.
  host.drag({100, 60}, {160, 80});
  EXPECT_GT(host.cameraEdits, 0);
  EXPECT_FALSE(host.view.pictureState().resting);
  ASSERT_TRUE(host.restOnProcessor());
  EXPECT_EQ(host.view.currentPicture(0), drawnByReference(host.scene, shown));
  refused.reset();
  QTest::mouseClick(host.view.findChild<QPushButton*>(QStringLiteral("retryGraphics")), Qt::LeftButton);
  ASSERT_TRUE(host.rest());
  EXPECT_FALSE(host.drawsOnProcessor());
  EXPECT_FALSE(host.bar().isVisible());
  EXPECT_EQ(host.errors.size(), 1u);
}

TEST(DriverFailure, bothSidesOfAComparisonAreDrawnByTheProcessor) {
  RestingHost host;
  host.view.setCompareLayout(CompareLayout::sideBySide);
  const test::BrokenShaders refused;
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.restOnProcessor());
  EXPECT_FALSE(host.view.currentPicture(1).isNull());
}

TEST(DriverFailure, withoutAProcessorTheSentenceStandsAlone) {
  ViewHost host;
  host.showPhantom(12.0);
  const test::BrokenShaders refused;
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(test::waitUntil([&] { return !host.errors.empty(); }));
  EXPECT_FALSE(host.drawsOnProcessor());
}

} // namespace
} // namespace limn
