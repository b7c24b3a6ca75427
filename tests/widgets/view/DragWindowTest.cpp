// SPDX-License-Identifier: GPL-3.0-or-later
#include "ViewHost.h"
#include "cpu/CpuEngine.h"
#include "support/Heads.h"
#include "support/Heart.h"
#include "support/Sanitizers.h"
#include "support/TestData.h"

#include <QElapsedTimer>

// The mouse drags a CT head about in 900 x 640 pixels, in a real window: how long the event loop is held, and
// how soon the picture is complete once nothing moves.

namespace limn {
namespace {

constexpr int moves = 40;

// Of one turn of the event loop, ms. The driver's pictures are drawn in turns, for which 40 ms are aimed at
// and which are then shown.
constexpr double slowness = test::isSanitised ? 10.0 : 1.0;
constexpr double mostMsOnProcessor = 20.0 * slowness;
constexpr double mostMsWithDriver = 100.0 * slowness;

constexpr double mostMsToFullQuality = 200.0; // on the processor

class Dragging : public testing::Test {
protected:
  // Drags in a circle, a move for each new picture, and waits for the full one.
  void dragWith(Engine engine, ShadingModel model) {
    LIMN_NEEDS_SHARED(test::ctHeadFile);
    test::ViewHost host(
        {900, 640}, [] { return makeCpuEngine(); }, engine);
    host.showPhantom(16.0);
    host.scene.volume = test::ctHead();
    host.scene.camera = defaultCamera(host.scene.volume->grid());
    host.scene.shading.model = model;
    host.view.setScene(host.scene);
    int pictures = 0;
    QObject::connect(&host.view, &CompareView::told, [&] { ++pictures; });
    ASSERT_TRUE(host.show());
    ASSERT_TRUE(host.rest());
    test::Heart heart;
    host.press({450, 320});
    for (int i = 1; i < moves; ++i) {
      const int before = pictures;
      host.move({450 + 3 * i, 320 + 2 * (i % 20)});
      ASSERT_TRUE(test::waitUntil([&] { return pictures > before; }));
      coarsest = std::min(coarsest, host.view.pictureState().sides[0].imageScale);
    }
    QElapsedTimer clock;
    clock.start();
    host.move({450 + 3 * moves, 320});
    ASSERT_TRUE(host.rest());
    restMs = 1e-6 * static_cast<double>(clock.nsecsElapsed());
    host.release({450 + 3 * moves, 320});
    const bool isDriver = engine == Engine::rayCaster;
    test::expectShortTurns(heart, isDriver ? "dragging with OpenGL" : "dragging on the processor",
                           isDriver ? mostMsWithDriver : mostMsOnProcessor);
    EXPECT_EQ(host.cameraEdits, moves);
    std::printf("coarsest picture %g of the pixels each way, full quality %.0f ms after the last move, drawn "
                "in %.0f\n",
                coarsest, restMs, host.view.pictureState().sides[0].shownMs);
  }

  double coarsest = 1.0;
  double restMs = 0.0;
};

TEST_F(Dragging, onTheProcessorHoldsNoTurnAndEndsInTheFullPicture) {
  dragWith(Engine::cpu, ShadingModel::classic);
  test::judgeMs("full quality after the last move, classic", restMs, mostMsToFullQuality);
}

TEST_F(Dragging, onTheProcessorHoldsNoTurnWithTheEnhancedModel) {
  dragWith(Engine::cpu, ShadingModel::enhanced);
  test::judgeMs("full quality after the last move, enhanced", restMs, mostMsToFullQuality);
}

TEST_F(Dragging, withOpenGlHoldsNoTurnForLong) {
  dragWith(Engine::rayCaster, ShadingModel::classic);
}

} // namespace
} // namespace limn
