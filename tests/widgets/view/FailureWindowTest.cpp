// SPDX-License-Identifier: GPL-3.0-or-later
#include "ViewHost.h"
#include "reference/ReferenceEngine.h"
#include "reference/ReferenceIntegrator.h"
#include "support/BrokenDriver.h"
#include "widgets/view/panels/ReferencePanel.h"
#include "widgets/view/pictures/FinishedPicture.h"

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

Image drawnByReference(const Scene& scene, const glm::ivec2& size) {
  return toImage(renderReference(scene, size, 1));
}

// A view at rest whose processor can draw.
struct RestingHost : ViewHost {
  RestingHost() : ViewHost({400, 240}, [] { return makeReferenceEngine(1); }) { showPhantom(12.0); }
  bool isOnProcessor() {
    return test::waitUntil([this] { return view.pictureState().processorIsDone; });
  }
  const ReferencePanel& panel() { return *view.findChild<ReferencePanel*>(); }
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
  QObject::connect(host.view.context(), &QOpenGLContext::aboutToBeDestroyed, &host.view, [&] {
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
  host.view.makeCurrent();
  test::forgetRayCasterPrograms();
  host.view.doneCurrent();
  host.scene.transferFunction.points[2].opacity = 0.4;
  host.view.setScene(host.scene);
  ASSERT_TRUE(test::waitUntil([&] { return restored.count() == 1; }));
  host.scene.transferFunction.points[2].opacity = 0.5;
  host.view.setScene(host.scene);
  ASSERT_TRUE(host.rest());
  EXPECT_EQ(host.view.restingImage(0), before);
  EXPECT_TRUE(host.errors.empty());
}

TEST(DriverFailure, whereEveryShaderIsRefusedTheReferenceDrawsAndSaysWhy) {
  RestingHost host;
  auto refused = std::make_unique<test::BrokenShaders>();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.isOnProcessor());
  EXPECT_TRUE(host.drawsOnProcessor());
  ASSERT_EQ(host.errors.size(), 1u);
  EXPECT_EQ(host.view.pictureState().driverFailure, host.errors[0]);
  EXPECT_TRUE(host.panel().isVisible());
  EXPECT_TRUE(
      host.view.findChild<QLabel*>(QStringLiteral("failureReason"))->text().startsWith(host.errors[0]));

  // The picture is the reference's, bit for bit.
  ASSERT_EQ(host.panel().pictures().size(), 1u);
  const QImage& shown = host.panel().pictures()[0];
  const glm::ivec2 size(shown.width(), shown.height());
  EXPECT_EQ(shown, overBackground(drawnByReference(host.scene, size), host.scene.image.background));

  // What the driver wrote can be copied.
  QTest::mouseClick(host.view.findChild<QPushButton*>(QStringLiteral("copyFailure")), Qt::LeftButton);
  EXPECT_TRUE(QGuiApplication::clipboard()->text().contains(QStringLiteral("a line of a test")));

  // Edits reach the picture, and the driver's recovery is taken up.
  host.scene.camera = orbited(host.scene.camera, 0.5, 0.0);
  host.view.setScene(host.scene);
  EXPECT_FALSE(host.view.pictureState().processorIsDone);
  ASSERT_TRUE(host.isOnProcessor());
  EXPECT_EQ(host.panel().pictures()[0],
            overBackground(drawnByReference(host.scene, size), host.scene.image.background));
  refused.reset();
  QTest::mouseClick(host.view.findChild<QPushButton*>(QStringLiteral("retryGraphics")), Qt::LeftButton);
  ASSERT_TRUE(host.rest());
  EXPECT_FALSE(host.drawsOnProcessor());
  EXPECT_FALSE(host.panel().isVisible());
  EXPECT_EQ(host.errors.size(), 1u);
}

TEST(DriverFailure, bothSidesOfAComparisonAreDrawnByTheReference) {
  RestingHost host;
  host.view.setCompareLayout(CompareLayout::sideBySide);
  const test::BrokenShaders refused;
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.isOnProcessor());
  EXPECT_EQ(host.panel().pictures().size(), 2u);
}

TEST(DriverFailure, withoutAReferenceTheSentenceStandsAlone) {
  ViewHost host;
  host.showPhantom(12.0);
  const test::BrokenShaders refused;
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(test::waitUntil([&] { return !host.errors.empty(); }));
  EXPECT_FALSE(host.drawsOnProcessor());
}

} // namespace
} // namespace limn
