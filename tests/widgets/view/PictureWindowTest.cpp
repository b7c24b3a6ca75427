// SPDX-License-Identifier: GPL-3.0-or-later
#include "ViewHost.h"
#include "gl/HeadlessContext.h"
#include "io/ImageFile.h"
#include "raycaster/RayCaster.h"
#include "support/Heart.h"
#include "support/TemporaryFolder.h"

#include <QColorSpace>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

// What the view draws, in a real window.

namespace limn {
namespace {

using test::ViewHost;

// In one format and without the colour space that a file names, so that == compares levels only.
QImage colours(const QImage& image) {
  QImage plain = image.convertToFormat(QImage::Format_RGB888);
  plain.setColorSpace({});
  return plain;
}

// The picture that the command line writes: another context without a window, a file, 8 bits.
QImage pictureFromFile(const Scene& scene, const QSize& size) {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "picture.png";
  {
    const HeadlessContext context;
    RayCaster caster;
    writeImage(path, caster.render(scene, {size.width(), size.height()}), scene.image.background, {});
  }
  return colours(QImage(QString::fromStdString(path.string())));
}

TEST(Picture, atRestIsBitForBitWhatTheCommandLineWrites) {
  ViewHost host({301, 203});
  host.showPhantom();
  host.scene.shading.model = ShadingModel::enhanced;
  host.scene.image.background = {0.3, 0.2, 0.1};
  host.view.setScene(host.scene);
  host.view.setOverlayVisible(false);
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  const QImage shown = colours(host.grabFramebuffer());
  const QImage kept = colours(host.view.currentPicture(0));
  host.canvas().doneCurrent(); // makes room for the command line's context
  const QImage expected = pictureFromFile(host.scene, host.view.size());
  EXPECT_EQ(shown, expected);
  EXPECT_EQ(kept, expected);
}

TEST(Picture, sideBySideShowsTwoModelsFromOneScene) {
  ViewHost host;
  host.view.setCompareLayout(CompareLayout::sideBySide);
  host.view.setOverlayVisible(false);
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  const QImage left = host.view.currentPicture(0);
  const QImage right = host.view.currentPicture(1);
  EXPECT_EQ(left.size(), QSize(199, 240)); // (400 - 2) / 2
  EXPECT_EQ(left.size(), right.size());
  EXPECT_NE(left, right);
  const QImage shown = colours(host.grabFramebuffer());
  EXPECT_EQ(shown.copy(0, 0, 199, 240), colours(left));
  EXPECT_EQ(shown.copy(201, 0, 199, 240), colours(right));
  EXPECT_EQ(host.view.sceneOfSide(0).shading.model, ShadingModel::classic);
  EXPECT_EQ(host.view.sceneOfSide(1).shading.model, ShadingModel::enhanced);
}

TEST(Picture, spaceSwapsTheSidesWhileHeld) {
  ViewHost host;
  host.view.setCompareLayout(CompareLayout::sideBySide);
  host.view.setOverlayVisible(false);
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  const QImage before = colours(host.grabFramebuffer());
  QTest::keyPress(&host.view, Qt::Key_Space);
  const QImage swapped = colours(host.grabFramebuffer());
  QTest::keyRelease(&host.view, Qt::Key_Space);
  EXPECT_EQ(swapped.copy(0, 0, 199, 240), before.copy(201, 0, 199, 240));
  EXPECT_EQ(swapped.copy(201, 0, 199, 240), before.copy(0, 0, 199, 240));
  EXPECT_EQ(colours(host.grabFramebuffer()), before);
}

TEST(Picture, theWipeShowsEachSidesPartOfItsPicture) {
  ViewHost host;
  host.view.setCompareLayout(CompareLayout::wipe);
  host.view.setOverlayVisible(false);
  host.view.setWipePosition(0.25);
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  const QImage shown = colours(host.grabFramebuffer());
  EXPECT_EQ(shown.copy(0, 0, 100, 240), colours(host.view.currentPicture(0)).copy(0, 0, 100, 240));
  EXPECT_EQ(shown.copy(100, 0, 300, 240), colours(host.view.currentPicture(1)).copy(100, 0, 300, 240));
}

TEST(Picture, theColourOfADifferenceTellsWhichSideIsBrighter) {
  ViewHost host;
  host.view.setCompareLayout(CompareLayout::difference);
  host.view.setOverlayVisible(false);
  host.view.setModels(ShadingModel::classic, ShadingModel::enhanced);
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  const QImage shown = colours(host.grabFramebuffer());
  const QImage left = colours(host.view.currentPicture(0));
  const QImage right = colours(host.view.currentPicture(1));
  int leftBrighter = 0, rightBrighter = 0;
  for (int y = 0; y < shown.height(); ++y)
    for (int x = 0; x < shown.width(); ++x) {
      const QColor one = left.pixelColor(x, y), other = right.pixelColor(x, y), told = shown.pixelColor(x, y);
      const std::array apart{other.red() - one.red(), other.green() - one.green(), other.blue() - one.blue()};
      const auto [least, most] = std::minmax_element(apart.begin(), apart.end());
      if (*least > -8 && *most > 8) { // beyond rounding, and of one sign
        ++rightBrighter;
        EXPECT_GT(told.red(), told.blue()) << x << ' ' << y;
      } else if (*least < -8 && *most < 8) {
        ++leftBrighter;
        EXPECT_LT(told.red(), told.blue()) << x << ' ' << y;
      }
    }
  EXPECT_GT(leftBrighter + rightBrighter, 100);
}

TEST(Picture, theDifferenceOfEqualSidesIsBlack) {
  ViewHost host;
  host.view.setCompareLayout(CompareLayout::difference);
  host.view.setOverlayVisible(false);
  host.view.setModels(ShadingModel::classic, ShadingModel::classic);
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  QImage black(400, 240, QImage::Format_RGB888);
  black.fill(Qt::black);
  EXPECT_EQ(colours(host.grabFramebuffer()), black);
  host.view.setModels(ShadingModel::classic, ShadingModel::enhanced);
  ASSERT_TRUE(host.rest());
  EXPECT_NE(colours(host.grabFramebuffer()), black);
}

TEST(Picture, editingTheTransferFunctionCompilesNoShader) {
  ViewHost host;
  host.view.setCompareLayout(CompareLayout::sideBySide);
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(test::waitUntil([&] { return host.isIdle(); }));
  const int before = host.compiledPrograms();
  EXPECT_GE(before, 2);
  const QImage old = host.view.currentPicture(0);
  host.scene.transferFunction = withPointMoved(host.scene.transferFunction, 2, 500.0, 0.2);
  host.view.setScene(host.scene);
  EXPECT_FALSE(host.view.pictureState().resting);
  EXPECT_TRUE(host.view.currentPicture(0).isNull());
  ASSERT_TRUE(host.rest());
  EXPECT_EQ(host.compiledPrograms(), before);
  EXPECT_NE(host.view.currentPicture(0), old);
}

TEST(Picture, refinementLeavesTheEventLoopFree) {
  {
    // The driver compiles the programs once and keeps them: how long it takes to is not what is asked here.
    ViewHost before({640, 400});
    before.view.setCompareLayout(CompareLayout::sideBySide);
    before.showPhantom(2.0);
    ASSERT_TRUE(before.show());
    ASSERT_TRUE(before.rest());
  }
  ViewHost host({640, 400});
  host.view.setCompareLayout(CompareLayout::sideBySide);
  host.showPhantom(2.0);
  ASSERT_TRUE(host.show());
  // The first picture uploads the volume and compiles; from then on the loop must keep turning.
  ASSERT_TRUE(test::waitUntil([&] { return !host.view.pictureState().sides.empty(); }));
  ASSERT_FALSE(host.view.pictureState().resting);
  const test::Heart heart;
  ASSERT_TRUE(host.rest());
  // A turn aims at 30 ms of drawing and a few of showing; rows that cost more than those before them and
  // slower machines than ours get the rest.
  test::expectShortTurns(heart, "while two phantoms are drawn", 250.0);
}

TEST(Picture, carriesItsOverlayIntoAGrabbedWindow) {
  ViewHost host;
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  const QImage shown = colours(host.grabFramebuffer());
  EXPECT_EQ(colours(host.view.grab().toImage()), shown);
  host.view.setOverlayVisible(false);
  EXPECT_NE(colours(host.grabFramebuffer()), shown);
}

TEST(Picture, isNeverEmptyWhileItRefines) {
  ViewHost host;
  host.view.setOverlayVisible(false);
  host.showPhantom(2.0);
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(test::waitUntil([&] { return !host.view.pictureState().sides.empty(); }));
  const QColor background = host.grabFramebuffer().pixelColor(1, 1);
  const auto showsTheHead = [&] { return host.grabFramebuffer().pixelColor(200, 120) != background; };
  for (int turn = 0; turn < 5; ++turn) {
    EXPECT_TRUE(showsTheHead());
    host.scene.camera = orbited(host.scene.camera, 0.1, 0.0);
    host.view.setScene(host.scene);
    EXPECT_TRUE(showsTheHead());
    QCoreApplication::processEvents();
  }
}

TEST(Picture, isDrawnAgainAfterTheViewMovedToAnotherWindow) {
  auto host = std::make_unique<ViewHost>();
  host->showPhantom();
  ASSERT_TRUE(host->show());
  ASSERT_TRUE(host->rest());
  const QImage before = host->view.currentPicture(0);
  QWidget window;
  QVBoxLayout column(&window);
  column.setContentsMargins(0, 0, 0, 0);
  column.addWidget(&host->view);
  window.resize(400, 240);
  window.show();
  ASSERT_TRUE(test::waitUntilExposed(window));
  ASSERT_TRUE(test::waitUntil([&] { return host->view.size() == QSize(400, 240); }));
  ASSERT_TRUE(host->rest());
  EXPECT_EQ(host->view.currentPicture(0), before);
  EXPECT_TRUE(host->errors.empty());
  host->view.setParent(nullptr);
}

} // namespace
} // namespace limn
