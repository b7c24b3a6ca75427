// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/PictureLoop.h"
#include "engine/DrawingEngine.h"
#include "raycaster/RayCaster.h"
#include "raycaster/RayCasterEngine.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/GlTest.h"
#include "widgets/view/pictures/GlScreen.h"

#include <QCoreApplication>

// The pictures in the turns of an event loop, without a window.

namespace limn {
namespace {

PictureRequest phantomRequest() {
  static const std::shared_ptr<const Volume> volume = phantomVolume({8.0, 0.0, 1});
  return {{headScene(volume, ShadingModel::enhanced)}, {60, 40}, {}, 1.0, QStringLiteral("Enhanced")};
}

class Loop : public test::GlTest {
protected:
  void SetUp() override {
    test::GlTest::SetUp();
    if (IsSkipped())
      return;
    PictureContext context;
    context.canDraw = [this] { return canDraw; };
    context.makeCurrent = context.doneCurrent = [] {};
    context.guard = [this](const PictureContext::Work& work) {
      try {
        work();
      } catch (const std::exception&) {
        canDraw = false;
      }
    };
    loop = std::make_unique<PictureLoop>(
        [] { return std::make_unique<Pictures>(makeRayCasterEngine(), makeGlScreen()); }, context);
    loop->setRefines(false);
    QObject::connect(loop.get(), &PictureLoop::showNeeded, [this] {
      if (canDraw)
        loop->drawIfStale(phantomRequest());
    });
    QObject::connect(loop.get(), &PictureLoop::completed, [this] { ++completions; });
    QObject::connect(loop.get(), &PictureLoop::effectsChanged,
                     [this](const std::vector<EffectRow>& rows, const QString& name) {
                       effects = rows;
                       picture = name;
                     });
    QObject::connect(loop.get(), &PictureLoop::timesChanged,
                     [this](const EffectTimes& told) { times = told; });
  }
  void TearDown() override { loop.reset(); } // while its context lives

  template <class Condition>
  void waitFor(Condition&& condition) {
    while (!condition())
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }

  bool canDraw = true;
  int completions = 0;
  std::vector<EffectRow> effects;
  QString picture;
  EffectTimes times;
  std::unique_ptr<PictureLoop> loop;
};

TEST_F(Loop, goesFromCoarseToCompleteToIdle) {
  loop->drawIfStale(phantomRequest());
  EXPECT_EQ(loop->state().sides.size(), 1u) << "a coarse picture is there at once";
  EXPECT_FALSE(loop->state().resting);
  EXPECT_EQ(loop->resting(0), nullptr);
  waitFor([this] { return completions == 1; });
  ASSERT_NE(loop->resting(0), nullptr);
  EXPECT_EQ(*loop->resting(0)->picture().image,
            RayCaster().render(phantomRequest().scenes[0], phantomRequest().size));
  waitFor([this] { return loop->isIdle(); });
  EXPECT_EQ(picture, QStringLiteral("Enhanced"));
  EXPECT_FALSE(effects.empty());
}

// 3 mm: several pieces of 16 planes. A piece a turn, all of them told.
TEST_F(Loop, uploadsALargeVolumeAPieceATurnAndSaysHowFarItIs) {
  PictureContext context;
  context.canDraw = [] { return true; };
  context.makeCurrent = context.doneCurrent = [] {};
  context.guard = [](const PictureContext::Work& work) { work(); };
  PicturePace pace;
  pace.budgetMs = 0.0;
  pace.tellMs = 0;
  loop = std::make_unique<PictureLoop>(
      [] { return std::make_unique<Pictures>(makeRayCasterEngine(), makeGlScreen()); }, context, pace);
  loop->setRefines(false);
  PictureRequest request = phantomRequest();
  request.scenes = {headScene(phantomVolume({3.0, 0.0, 1}), ShadingModel::enhanced)};
  std::vector<double> told;
  int turns = 0;
  QObject::connect(loop.get(), &PictureLoop::preparing, [&](double fraction) { told.push_back(fraction); });
  QObject::connect(loop.get(), &PictureLoop::showNeeded, [&] {
    turns += loop->isPreparing() ? 1 : 0;
    loop->drawIfStale(request);
  });
  loop->drawIfStale(request);
  EXPECT_TRUE(loop->isPreparing());
  EXPECT_FALSE(loop->state().resting);
  waitFor([&] { return loop->state().resting; });
  EXPECT_GE(turns, 2);
  ASSERT_GE(told.size(), 2u);
  EXPECT_GT(told.front(), 0.0);
  EXPECT_LT(told.front(), 1.0);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1.0);
  EXPECT_EQ(*loop->resting(0)->picture().image, RayCaster().render(request.scenes[0], request.size));
}

TEST_F(Loop, drawsNothingAnewUntilSomethingChanged) {
  loop->drawIfStale(phantomRequest());
  waitFor([this] { return loop->isIdle(); });
  const int before = completions;
  loop->drawIfStale(phantomRequest());
  EXPECT_TRUE(loop->state().resting);
  loop->restart();
  EXPECT_FALSE(loop->state().resting);
  loop->drawIfStale(phantomRequest());
  waitFor([&] { return completions > before; });
}

TEST_F(Loop, measuresOnRequestWhatEffectsCost) {
  loop->drawIfStale(phantomRequest());
  waitFor([this] { return loop->isIdle() && !effects.empty(); });
  EXPECT_EQ(times, EffectTimes{}) << "nobody asked";
  loop->measureEffects();
  waitFor([this] { return !times.costs.empty(); });
  EXPECT_EQ(times.costs.size(), effects.size());
  loop->restart();
  waitFor([this] { return times == EffectTimes{}; });
}

TEST_F(Loop, stopsWhereNothingCanBeDrawn) {
  loop->drawIfStale(phantomRequest());
  canDraw = false;
  for (int turn = 0; turn < 5; ++turn)
    QCoreApplication::processEvents(QEventLoop::AllEvents, 100);
  EXPECT_EQ(completions, 0);
  loop->release(false);
  EXPECT_EQ(loop->pictures(), nullptr);
  EXPECT_EQ(loop->state(), PictureState{});
}

TEST_F(Loop, withoutRoomDrawsNothing) {
  PictureRequest request = phantomRequest();
  request.size = {0, 0};
  loop->drawIfStale(request);
  EXPECT_TRUE(loop->state().sides.empty());
}

} // namespace
} // namespace limn
