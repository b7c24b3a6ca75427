// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/PictureLoop.h"
#include "cpu/CpuEngine.h"
#include "engine/DrawingEngine.h"
#include "raycaster/RayCaster.h"
#include "raycaster/RayCasterEngine.h"
#include "scene/basics/Error.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/GlTest.h"
#include "widgets/view/pictures/PictureScreen.h"

#include <QCoreApplication>

// The pictures in the turns of an event loop, without a window.

namespace limn {
namespace {

PictureOrder phantomOrder() {
  static const std::shared_ptr<const Volume> volume = phantomVolume({8.0, 0.0, 1});
  PictureOrder order;
  order.isSeen = true;
  order.scenes = {headScene(volume, ShadingModel::enhanced)};
  order.size = {60, 40};
  order.lastName = QStringLiteral("Enhanced");
  order.refines = false;
  return order;
}

class Loop : public test::GlTest {
protected:
  void SetUp() override {
    test::GlTest::SetUp();
    if (!IsSkipped())
      makeLoop({});
  }
  void TearDown() override { loop.reset(); } // while its context lives

  void makeLoop(const PicturePace& pace) {
    PictureContext context;
    context.makeCurrent = context.doneCurrent = [] {};
    context.guard = [this](const PictureContext::Work& work) {
      try {
        work();
      } catch (const std::exception&) {
        hide();
      }
    };
    loop = std::make_unique<PictureLoop>(
        [] { return std::make_unique<Pictures>(makeRayCasterEngine(), makeGlScreen()); }, context, pace);
    QObject::connect(loop.get(), &PictureLoop::showNeeded, [this] {
      if (loop->order().isSeen)
        loop->drawIfStale();
    });
    QObject::connect(loop.get(), &PictureLoop::told, [this](const ViewNews& told) {
      ++tellings;
      completions += told.state.resting && !news.state.resting ? 1 : 0;
      news = told;
    });
  }

  template <class Condition>
  void waitFor(Condition&& condition) {
    while (!condition())
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  }

  void draw(const PictureOrder& order = phantomOrder()) {
    loop->show(order);
    loop->drawIfStale();
  }
  void hide() {
    PictureOrder order = loop->order();
    order.isSeen = false;
    loop->show(order);
  }

  int tellings = 0;
  int completions = 0;
  ViewNews news;
  std::unique_ptr<PictureLoop> loop;
};

TEST_F(Loop, goesFromCoarseToCompleteToIdle) {
  PicturePace pace;
  pace.budgetMs = 1e6; // the volume is ready within the first turn, however busy the machine is
  makeLoop(pace);
  draw();
  EXPECT_EQ(loop->state().sides.size(), 1u) << "a coarse picture is there at once";
  EXPECT_FALSE(loop->state().resting);
  EXPECT_EQ(loop->resting(0), nullptr);
  waitFor([this] { return completions == 1; });
  ASSERT_NE(loop->resting(0), nullptr);
  EXPECT_EQ(*loop->resting(0)->picture().image,
            RayCaster().render(phantomOrder().scenes[0], phantomOrder().size));
  waitFor([this] { return loop->isIdle(); });
  EXPECT_EQ(news.effectsOf, QStringLiteral("Enhanced"));
  EXPECT_FALSE(news.effects.empty());
  EXPECT_EQ(news, loop->news());
}

// 3 mm: several pieces of 16 planes. A piece a turn, all of them told.
TEST_F(Loop, uploadsALargeVolumeAPieceATurnAndSaysHowFarItIs) {
  PictureContext context;
  context.makeCurrent = context.doneCurrent = [] {};
  context.guard = [](const PictureContext::Work& work) { work(); };
  PicturePace pace;
  pace.budgetMs = 0.0;
  pace.tellMs = 0;
  loop = std::make_unique<PictureLoop>(
      [] { return std::make_unique<Pictures>(makeRayCasterEngine(), makeGlScreen()); }, context, pace);
  PictureOrder order = phantomOrder();
  order.scenes = {headScene(phantomVolume({3.0, 0.0, 1}), ShadingModel::enhanced)};
  std::vector<double> told;
  int turns = 0;
  QObject::connect(loop.get(), &PictureLoop::told, [&](const ViewNews& last) {
    if (last.prepared != (told.empty() ? 1.0 : told.back()))
      told.push_back(last.prepared);
  });
  QObject::connect(loop.get(), &PictureLoop::showNeeded, [&] {
    turns += loop->isPreparing() ? 1 : 0;
    loop->drawIfStale();
  });
  draw(order);
  EXPECT_TRUE(loop->isPreparing());
  EXPECT_FALSE(loop->state().resting);
  waitFor([&] { return loop->state().resting; });
  EXPECT_GE(turns, 2);
  ASSERT_GE(told.size(), 2u);
  EXPECT_GT(told.front(), 0.0);
  EXPECT_LT(told.front(), 1.0);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_EQ(told.back(), 1.0);
  EXPECT_EQ(*loop->resting(0)->picture().image, RayCaster().render(order.scenes[0], order.size));
}

TEST_F(Loop, anEqualOrderDrawsNothing) {
  draw();
  waitFor([this] { return loop->isIdle(); });
  const int before = tellings;
  draw();
  EXPECT_TRUE(loop->state().resting);
  EXPECT_TRUE(loop->isIdle());
  EXPECT_EQ(tellings, before) << "and there is no news";
}

TEST_F(Loop, whatIsPutTogetherOtherwiseIsNotDrawnAnew) {
  draw();
  waitFor([this] { return loop->isIdle(); });
  PictureOrder order = phantomOrder();
  order.wipeColumn = 7;
  order.seen[0].to = 0.5;
  order.isSwapped = true;
  draw(order);
  EXPECT_TRUE(loop->state().resting);
  order.isSeen = false;
  loop->show(order);
  order.isSeen = true;
  draw(order);
  EXPECT_TRUE(loop->state().resting) << "hidden and seen again";
  waitFor([this] { return loop->isIdle(); });
  EXPECT_EQ(completions, 1);
}

TEST_F(Loop, anotherSceneAndAnotherAttemptAreDrawnAnew) {
  draw();
  waitFor([this] { return loop->isIdle(); });
  PictureOrder order = phantomOrder();
  order.scenes[0].camera = orbited(order.scenes[0].camera, 0.1, 0.0);
  loop->show(order);
  EXPECT_FALSE(news.state.resting) << "said at once";
  draw(order);
  waitFor([this] { return completions == 2; });
  ++order.attempt;
  draw(order);
  EXPECT_FALSE(loop->state().resting);
  waitFor([this] { return completions == 3; });
}

TEST_F(Loop, measuresOnRequestWhatEffectsCost) {
  draw();
  waitFor([this] { return loop->isIdle() && !news.effects.empty(); });
  EXPECT_EQ(news.times, EffectTimes{}) << "nobody asked";
  loop->measureEffects();
  waitFor([this] { return !news.times.costs.empty(); });
  EXPECT_EQ(news.times.costs.size(), news.effects.size());
  loop->measureEffects();
  EXPECT_TRUE(news.times.isMeasuring) << "anew";
  EXPECT_TRUE(news.times.costs.empty());
  waitFor([this] { return !news.times.costs.empty(); });
  loop->measureEffects();
  loop->measureEffects(false);
  EXPECT_EQ(news.times, EffectTimes{}) << "cancelled";
  waitFor([this] { return loop->isIdle(); });
  EXPECT_EQ(news.times, EffectTimes{});
  loop->measureEffects();
  PictureOrder order = phantomOrder();
  ++order.attempt;
  loop->show(order);
  EXPECT_EQ(news.times, EffectTimes{});
}

TEST_F(Loop, withoutAVolumeThereIsNothingToTell) {
  draw();
  waitFor([this] { return loop->isIdle() && !news.effects.empty(); });
  loop->show({});
  EXPECT_EQ(news.state, PictureState{});
  EXPECT_TRUE(news.effects.empty());
  EXPECT_TRUE(news.effectsOf.isEmpty());
}

TEST_F(Loop, stopsWhereNothingIsSeen) {
  draw();
  hide();
  for (int turn = 0; turn < 5; ++turn)
    QCoreApplication::processEvents(QEventLoop::AllEvents, 100);
  EXPECT_EQ(completions, 0);
  loop->release(false);
  EXPECT_EQ(loop->pictures(), nullptr);
  EXPECT_EQ(loop->state(), PictureState{});
}

// An order that is the same as the last, after one in between that nobody began, ends what is drawn and
// brings nothing else to show. Without OpenGL, as only the processor's pictures are interrupted.
TEST(LoopInMemory, whatIsInterruptedAtRestIsTakenUpAgain) {
  bool isCoarse = false;
  int interruptions = 0;
  PictureContext context;
  context.makeCurrent = context.doneCurrent = [] {};
  context.guard = [](const PictureContext::Work& work) {
    try {
      work();
    } catch (const Cancelled&) {
    }
  };
  PictureLoop loop(
      [&] {
        return std::make_unique<Pictures>(makeCpuEngine(2), makeMemoryScreen([&] {
                                            // Every kind of work at rest, and the estimate before it.
                                            const bool ends = !isCoarse && interruptions < 9;
                                            interruptions += ends ? 1 : 0;
                                            return ends;
                                          }));
      },
      context);
  const auto draw = [&] {
    isCoarse = true;
    loop.drawIfStale();
    isCoarse = false;
  };
  QObject::connect(&loop, &PictureLoop::showNeeded, draw);
  PictureOrder order = phantomOrder();
  order.refines = true;
  loop.show(order);
  draw();
  while (!loop.state().refinementEnd || !loop.isIdle())
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  EXPECT_EQ(interruptions, 9);
  ASSERT_EQ(loop.state().sides.size(), 1u);
  EXPECT_TRUE(loop.state().sides[0].estimate);
  EXPECT_TRUE(loop.state().sides[0].overflow);
}

// The whole picture before the exact one is drawn at a level of its own, however fast a finer one would be:
// it is noted as that and drawn no finer, so that the exact one begins.
TEST(LoopInMemory, beforeATolerancedPictureWithLightAWholeOneStands) {
  PictureContext context;
  context.makeCurrent = context.doneCurrent = [] {};
  context.guard = [](const PictureContext::Work& work) { work(); };
  PictureLoop loop([] { return std::make_unique<Pictures>(makeCpuEngine(2), makeMemoryScreen({})); },
                   context);
  QObject::connect(&loop, &PictureLoop::showNeeded, [&] { loop.drawIfStale(); });
  PictureOrder order = phantomOrder();
  order.movingMs = 1e9; // any level is fast enough
  Scene& scene = order.scenes.front();
  scene.shading.model = ShadingModel::classic;
  scene.shading.lightDirection = glm::normalize(glm::dvec3(1, 1, -1));
  scene.shading.shadow.strength = 0.7;
  scene.quality.toleranceLevels = 4.0;
  scene.quality.fineness = 2.0;
  bool wasWhole = false;
  QObject::connect(&loop, &PictureLoop::told, [&](const ViewNews& news) {
    if (!news.state.resting && !news.state.sides.empty())
      wasWhole = wasWhole || (news.state.sides[0].imageScale == 1.0 && news.state.sides[0].fraction == 0.0);
  });
  loop.show(order);
  loop.drawIfStale();
  while (!loop.state().resting)
    QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
  EXPECT_TRUE(wasWhole);
}

TEST_F(Loop, withoutRoomDrawsNothing) {
  PictureOrder order = phantomOrder();
  order.size = {0, 0};
  draw(order);
  EXPECT_TRUE(loop->state().sides.empty());
}

} // namespace
} // namespace limn
