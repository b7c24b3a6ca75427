// SPDX-License-Identifier: GPL-3.0-or-later
#include "ViewHost.h"
#include "cpu/CpuEngine.h"
#include "cpu/CpuRenderer.h"
#include "scene/basics/Error.h"
#include "support/MappedVolume.h"
#include "support/TemporaryFolder.h"
#include "widgets/view/overlay/Overlay.h"
#include "widgets/view/pictures/PictureScreen.h"

#include <QSignalSpy>

// The processor draws a view, in a real window: everything that a view does, without a widget with OpenGL.

namespace limn {
namespace {

std::unique_ptr<DrawingEngine> onOneThread() {
  return makeCpuEngine(1);
}

struct ProcessorHost : test::ViewHost {
  ProcessorHost() : ViewHost({301, 203}, onOneThread, Engine::cpu) {
    view.setOverlayVisible(false);
    showPhantom();
  }
  [[nodiscard]] bool isShowing(const QImage& expected) {
    return test::waitUntil([&] { return seen() == expected.convertToFormat(QImage::Format_RGB32); });
  }
  QImage seen() { return view.grab().toImage().convertToFormat(QImage::Format_RGB32); }
  QImage drawn(int side) const {
    const Scene shown = view.sceneOfSide(side);
    const QRectF place = view.logicalRect(side);
    const glm::ivec2 size(static_cast<int>(place.width()), static_cast<int>(place.height()));
    return overBackground(CpuRenderer(1).render(shown, size), shown.image.background);
  }
};

TEST(OnProcessor, thePictureAtRestIsBitForBitTheEnginesAndSoIsWhatIsSeen) {
  ProcessorHost host;
  host.scene.image.background = {0.3, 0.2, 0.1};
  host.view.setScene(host.scene);
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  EXPECT_EQ(host.view.findChild<QOpenGLWidget*>(), nullptr);
  EXPECT_EQ(host.view.currentPicture(0), host.drawn(0));
  EXPECT_TRUE(host.isShowing(host.drawn(0)));
  EXPECT_EQ(host.view.pictureState().engine, Engine::cpu);
  EXPECT_FALSE(host.view.pictureState().driverHasFailed);
}

TEST(OnProcessor, aDragMovesThePictureAndItComesToRestAgain) {
  ProcessorHost host;
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  const QImage before = host.view.currentPicture(0);
  host.drag({100, 100}, {140, 110});
  EXPECT_GE(host.cameraEdits, 2);
  EXPECT_FALSE(host.view.pictureState().resting) << "what was complete is stale at once";
  EXPECT_TRUE(host.view.currentPicture(0).isNull());
  ASSERT_TRUE(host.rest());
  EXPECT_NE(host.view.currentPicture(0), before);
  EXPECT_EQ(host.view.currentPicture(0), host.drawn(0));
}

// A late picture is the old one: letters of the new camera would name wrong sides of it.
TEST(OnProcessor, lettersTurnTogetherWithThePictureThatIsSeen) {
  ProcessorHost host;
  host.view.setOverlayVisible(true);
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  const Overlay overlay = overlayOf({host.view.order(), host.view.pictureState()});
  ASSERT_FALSE(overlay.letters.empty());
  const std::optional<QRectF> left = overlay.letters[0].places[0];
  ASSERT_TRUE(left);
  const auto letter = [&] { return host.seen().copy(left->toAlignedRect()); };
  const QImage before = letter();
  host.scene.camera = orbited(host.scene.camera, 1.5707963, 0.0);
  host.view.setScene(host.scene);
  EXPECT_EQ(letter(), before) << "the next picture comes in a later turn of the event loop";
  ASSERT_TRUE(host.rest());
  EXPECT_NE(letter(), before);
}

TEST(OnProcessor, ofAnotherVolumeNothingIsToldUntilItIsSeen) {
  ProcessorHost host;
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  PictureState told = host.view.pictureState();
  QObject::connect(&host.view, &CompareView::told, [&](const ViewNews& news) { told = news.state; });
  host.showPhantom(8.0);
  EXPECT_TRUE(told.sides.empty() && !told.resting) << "what was true of the volume before";
  ASSERT_TRUE(host.rest());
  EXPECT_EQ(host.view.currentPicture(0), host.drawn(0));
}

TEST(OnProcessor, aVolumeOnDiskMovesInFewerVoxelsAndRestsInAll) {
  const test::TemporaryFolder folder;
  ProcessorHost host;
  const std::shared_ptr<const Volume> inMemory = host.scene.volume;
  host.scene.volume = test::mapped(*inMemory, folder.path() / "voxels");
  host.view.setScene(host.scene);
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  int coarse = 0;
  QObject::connect(&host.view, &CompareView::told, &host.view, [&](const ViewNews& news) {
    const PictureState& state = news.state;
    coarse += !state.sides.empty() && state.sides[0].coarseness ? 1 : 0;
  });
  host.drag({100, 100}, {140, 110});
  ASSERT_TRUE(test::waitUntil([&] { return coarse > 0; })) << "the status bar is told";
  ASSERT_TRUE(host.rest());
  EXPECT_FALSE(host.view.pictureState().sides[0].coarseness);
  const QImage rested = host.view.currentPicture(0);
  EXPECT_EQ(rested, host.drawn(0));
  host.scene.volume = inMemory;
  host.scene.camera = host.view.sceneOfSide(0).camera;
  host.view.setScene(host.scene);
  ASSERT_TRUE(host.rest());
  EXPECT_EQ(host.view.currentPicture(0), rested) << "where the voxels lie changes no bit";
}

TEST(OnProcessor, sidesSwapAndTheWipeMovesWithoutDrawingAnew) {
  ProcessorHost host;
  host.view.setCompareLayout(CompareLayout::wipe);
  host.view.setModels(ShadingModel::none, ShadingModel::robust);
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  host.view.setWipePosition(0.0);
  EXPECT_TRUE(host.isShowing(host.drawn(1)));
  host.view.setWipePosition(1.0);
  EXPECT_TRUE(host.isShowing(host.drawn(0)));
  EXPECT_TRUE(host.view.pictureState().resting);
  QTest::keyPress(&host.view, Qt::Key_Space);
  EXPECT_TRUE(host.isShowing(host.drawn(1)));
  QTest::keyRelease(&host.view, Qt::Key_Space);
  EXPECT_TRUE(host.isShowing(host.drawn(0)));
}

TEST(OnProcessor, refinesAtRestToThePictureOfTheQualityThatItStates) {
  ProcessorHost host;
  host.view.setRefinesAtRest(true);
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(test::waitUntil([&] {
    const PictureState state = host.view.pictureState();
    return state.resting && state.sides[0].estimate && !state.sides[0].isRough;
  }));
  const Scene asShown = host.view.sceneOfRestingImage(0);
  EXPECT_NE(asShown.quality, host.scene.quality);
  const std::optional<Image> shown = host.view.restingImage(0);
  ASSERT_TRUE(shown);
  EXPECT_EQ(*shown, CpuRenderer(1, CpuRenderer::Tolerance::stepsFirst).render(asShown, shown->size));
}

TEST(OnProcessor, itsStateTellsTheErrorOfThePictureAndItsEffects) {
  ProcessorHost host;
  std::size_t effects = 0;
  QObject::connect(&host.view, &CompareView::told,
                   [&](const ViewNews& news) { effects = news.effects.size(); });
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(test::waitUntil([&] {
    const PictureState state = host.view.pictureState();
    return state.resting && state.sides[0].estimate && state.sides[0].overflow;
  }));
  EXPECT_GE(effects, 1u);
  EXPECT_TRUE(host.view.pictureState().renderer.startsWith(QStringLiteral("CPU engine")));
}

// However long the thread takes to end a piece of what it draws.
TEST(OnProcessor, aMeasurementOfCostsIsSaidAtOnce) {
  ProcessorHost host;
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  EffectTimes times;
  QObject::connect(&host.view, &CompareView::told, [&](const ViewNews& news) { times = news.times; });
  host.view.measureEffects();
  QCoreApplication::processEvents();
  EXPECT_TRUE(times.isMeasuring);
  EXPECT_TRUE(test::waitUntil([&] { return !times.isMeasuring && !times.costs.empty(); }));
  host.view.measureEffects();
  host.view.measureEffects(false);
  QCoreApplication::processEvents();
  EXPECT_EQ(times, EffectTimes{}) << "cancelled";
  ASSERT_TRUE(host.rest());
  EXPECT_EQ(times, EffectTimes{});
}

TEST(OnProcessor, whatChangesWhileTheViewIsHiddenIsDrawnOnceItIsSeen) {
  ProcessorHost host;
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  host.view.hide();
  host.scene.camera = orbited(host.scene.camera, 0.4, 0.0);
  host.view.setScene(host.scene);
  EXPECT_FALSE(host.view.pictureState().resting);
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  EXPECT_EQ(host.view.currentPicture(0), host.drawn(0));
}

TEST(OnProcessor, closingTheVolumeLeavesTheBackground) {
  ProcessorHost host;
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  host.view.setScene({});
  EXPECT_FALSE(host.view.pictureState().resting);
  EXPECT_TRUE(host.view.currentPicture(0).isNull());
}

TEST(OnProcessor, anErrorIsSaidAndTheNextSceneIsDrawn) {
  bool refuses = true;
  test::ViewHost host(
      {200, 120},
      [&refuses] {
        if (std::exchange(refuses, false))
          throw Error(Error::Kind::input, "The volume is broken.");
        return onOneThread();
      },
      Engine::cpu);
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(test::waitUntil([&] { return !host.errors.empty(); }));
  EXPECT_EQ(host.errors[0], QStringLiteral("The volume is broken."));
  host.scene.transferFunction.points[2].opacity = 0.4;
  host.view.setScene(host.scene);
  EXPECT_TRUE(host.rest());
}

TEST(Engines, oneReplacesTheOtherAndEachDrawsItsPicture) {
  ProcessorHost host;
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  host.view.setEngine(Engine::rayCaster, QStringLiteral("Chosen."));
  EXPECT_FALSE(host.view.pictureState().resting);
  ASSERT_TRUE(host.rest());
  EXPECT_EQ(host.view.pictureState().engine, Engine::rayCaster);
  EXPECT_EQ(host.view.pictureState().engineReason, QStringLiteral("Chosen."));
  EXPECT_FALSE(host.grabFramebuffer().isNull());
  host.view.setEngine(Engine::cpu, {});
  ASSERT_TRUE(host.rest());
  EXPECT_EQ(host.view.findChild<QOpenGLWidget*>(), nullptr);
  EXPECT_TRUE(host.isShowing(host.drawn(0)));
  EXPECT_TRUE(host.errors.empty());
}

// The driver may have one megabyte: the finer phantom does not fit, the coarser one does.
TEST(Engines, aVolumeThatIsTooLargeForTheDriverGoesToTheProcessorAloneAndSaysSo) {
  CompareView view({[] { return makeRayCasterEngineWithin(1.0); }, onOneThread, {}});
  view.resize(200, 120);
  view.setRefinesAtRest(false);
  Scene scene;
  const auto open = [&](double spacingMm) {
    scene.volume = phantomVolume({spacingMm, 0.0, 1});
    scene.camera = defaultCamera(scene.volume->grid());
    scene.transferFunction.points = {{-300, {0.9, 0.6, 0.5}, 0.0}, {300, {1.0, 0.95, 0.85}, 0.5}};
    view.setScene(scene);
  };
  const auto rests = [&](Engine engine) {
    return test::waitUntil([&] { return view.engine() == engine && view.pictureState().resting; });
  };
  view.show();
  ASSERT_TRUE(test::waitUntilExposed(view));
  open(2.0);
  ASSERT_TRUE(rests(Engine::cpu));
  const PictureState state = view.pictureState();
  EXPECT_TRUE(state.limitation.contains(QStringLiteral("too large"))) << state.limitation.toStdString();
  EXPECT_TRUE(state.limitation.endsWith(QStringLiteral("The processor draws it.")));
  EXPECT_FALSE(state.driverHasFailed);
  EXPECT_EQ(*view.restingImage(0), CpuRenderer(1).render(scene, {200, 120})) << "in all its voxels";
  open(16.0);
  ASSERT_TRUE(rests(Engine::rayCaster));
  EXPECT_TRUE(view.pictureState().limitation.isEmpty());
}

} // namespace
} // namespace limn
