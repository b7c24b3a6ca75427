// SPDX-License-Identifier: GPL-3.0-or-later
#include "ViewHost.h"
#include "gl/HeadlessContext.h"
#include "raycaster/RayCaster.h"
#include "support/Heart.h"
#include "widgets/view/pictures/Refinement.h"

#include <QColorSpace>

#include <cmath>
#include <cstdio>

// How resting pictures go on to smaller steps, in a real window.

namespace limn {
namespace {

using test::ViewHost;

struct RefiningHost : ViewHost {
  explicit RefiningHost(const QSize& size = {240, 160}) : ViewHost(size) { view.setRefinesAtRest(true); }
  [[nodiscard]] bool refined() {
    return test::waitUntil([this] { return isIdle() && view.pictureState().refinementEnd; });
  }
  [[nodiscard]] bool firstPass() {
    return test::waitUntil([this] {
      const PictureState& state = view.pictureState();
      return state.resting && state.sides[0].estimate && !state.sides[0].isRough;
    });
  }
};

// What the command line draws: another context without a window.
Image rendered(const Scene& scene, const glm::ivec2& size) {
  const HeadlessContext context;
  RayCaster caster;
  return caster.render(scene, size);
}

void expectThatVeryPicture(RefiningHost& host) {
  const std::optional<Image> shown = host.view.restingImage(0);
  const Scene asShown = host.view.sceneOfRestingImage(0);
  EXPECT_NE(asShown.quality, host.scene.quality);
  EXPECT_EQ(host.view.scene().quality, host.scene.quality) << "what the user chose";
  host.canvas().doneCurrent(); // makes room for the other context
  ASSERT_TRUE(shown);
  EXPECT_TRUE(rendered(asShown, {240, 160}) == *shown);
}

void expectHalvings(const PictureState& state, const Scene& scene) {
  const SideState& side = state.sides[0];
  std::printf("estimate %.3f levels at step 1/%g\n", side.estimate->p99_9, 1.0 / side.stepVoxels);
  const double halvings = std::log2(scene.quality.stepVoxels / side.stepVoxels);
  EXPECT_GE(halvings, 1.0);
  EXPECT_EQ(halvings, std::floor(halvings));
  if (*state.refinementEnd == RefinementEnd::withinHalfALevel)
    EXPECT_LE(side.estimate->p99_9, halfALevel);
  else
    EXPECT_LT(side.stepVoxels / 2.0, Refinement::smallestStepVoxels);
}

// Which road is shorter depends on the machine.
TEST(Refinement, comesWithinHalfALevelOrToTheSmallestStepAndShowsThatVeryPicture) {
  RefiningHost host;
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.refined());
  const PictureState state = host.view.pictureState();
  const SideState& side = state.sides[0];
  ASSERT_TRUE(side.estimate);
  EXPECT_FALSE(side.isRough);
  EXPECT_TRUE(side.isResolved);
  if (side.toleranceLevels) {
    std::printf("estimate %.3f levels with error-controlled steps\n", side.estimate->p99_9);
    EXPECT_EQ(*side.toleranceLevels, Refinement::toleranceLevels);
    EXPECT_EQ(*state.refinementEnd, RefinementEnd::withinHalfALevel);
    EXPECT_LE(side.estimate->p99_9, Refinement::toleranceLevels);
  } else {
    expectHalvings(state, host.scene);
  }
  expectThatVeryPicture(host);
}

// A projection without error-controlled steps.
TEST(Refinement, halvesTheStepOfTheBrightestSampleUntilHalfALevelOrTheSmallest) {
  RefiningHost host;
  host.showPhantom();
  host.scene.projection = Projection::mip;
  host.view.setScene(host.scene);
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.refined());
  const PictureState state = host.view.pictureState();
  ASSERT_TRUE(state.sides[0].estimate);
  EXPECT_FALSE(state.sides[0].toleranceLevels);
  expectHalvings(state, host.scene);
  expectThatVeryPicture(host);
}

// Its own tolerance was kept before: from there on all steps are halved.
TEST(Refinement, ofASceneWithAToleranceBeginsWithIt) {
  RefiningHost host;
  host.showPhantom();
  host.scene.quality.toleranceLevels = 2.0;
  host.scene.quality.fineness = 3.0;
  host.view.setScene(host.scene);
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.refined());
  const Quality quality = host.view.sceneOfRestingImage(0).quality;
  EXPECT_EQ(quality.toleranceLevels, 2.0);
  EXPECT_GE(*quality.fineness, 5.0);
  expectThatVeryPicture(host);
}

TEST(Refinement, takesBothSidesOneRoad) {
  RefiningHost host;
  host.view.setCompareLayout(CompareLayout::sideBySide);
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.refined());
  const PictureState state = host.view.pictureState();
  ASSERT_EQ(state.sides.size(), 2u);
  EXPECT_EQ(state.sides[0].stepVoxels, state.sides[1].stepVoxels);
  EXPECT_EQ(state.sides[0].toleranceLevels, state.sides[1].toleranceLevels);
  const std::optional<Image> right = host.view.restingImage(1);
  const Scene asShown = host.view.sceneOfRestingImage(1);
  EXPECT_EQ(asShown.shading.model, ShadingModel::enhanced);
  host.canvas().doneCurrent();
  EXPECT_TRUE(rendered(asShown, right->size) == *right);
}

TEST(Refinement, showsTheNewRowsAboveTheOldPictureWhileItDraws) {
  RefiningHost host({300, 300});
  host.view.setOverlayVisible(false);
  host.showPhantom(3.0);
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(test::waitUntil([&] { return host.view.pictureState().refinementFraction > 0.3; }));
  const QImage before = host.view.currentPicture(0);
  const QImage shown = host.grabFramebuffer();
  ASSERT_FALSE(before.isNull()) << "the last complete picture can be saved all the time";
  // The lowest rows are those of the last complete picture.
  const QRect lowest(0, 290, 300, 10);
  QImage kept = before.convertToFormat(QImage::Format_RGB888).copy(lowest);
  QImage seen = shown.convertToFormat(QImage::Format_RGB888).copy(lowest);
  kept.setColorSpace({});
  seen.setColorSpace({});
  EXPECT_EQ(seen, kept);
}

TEST(Refinement, isSaidToBeUnderWayFromTheFirstMomentOfRest) {
  RefiningHost host;
  int rests = 0;
  int doubts = 0; // at rest, not at its end, and nothing said to come
  QObject::connect(&host.view, &CompareView::told, &host.view, [&](const ViewNews& news) {
    const PictureState& state = news.state;
    rests += state.resting;
    doubts += state.resting && !state.refinementEnd && !state.refines;
  });
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.refined());
  EXPECT_GT(rests, 1);
  EXPECT_EQ(doubts, 0);
}

TEST(Refinement, givesWayToAnyChangeAtOnceAndBeginsAnew) {
  RefiningHost host;
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.firstPass());
  host.scene.camera = orbited(host.scene.camera, 0.2, 0.0);
  host.view.setScene(host.scene);
  EXPECT_FALSE(host.view.pictureState().resting);
  EXPECT_FALSE(host.view.pictureState().refines);
  EXPECT_FALSE(host.view.restingImage(0));
  ASSERT_TRUE(test::waitUntil([&] { return host.view.pictureState().resting; }));
  EXPECT_EQ(host.view.sceneOfRestingImage(0).quality, host.scene.quality) << "first the scene's own";
  ASSERT_TRUE(host.refined());
  EXPECT_NE(host.view.sceneOfRestingImage(0).quality, host.scene.quality);
}

TEST(Refinement, canBeSwitchedOffAndOnAtRest) {
  RefiningHost host;
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.firstPass());
  host.view.setRefinesAtRest(false);
  ASSERT_TRUE(test::waitUntil([&] { return host.isIdle(); }));
  const Quality kept = host.view.sceneOfRestingImage(0).quality;
  EXPECT_FALSE(host.view.pictureState().refines);
  EXPECT_NE(kept, host.scene.quality) << "what was drawn stays";
  host.view.setRefinesAtRest(true);
  ASSERT_TRUE(host.refined());
  const Quality quality = host.view.sceneOfRestingImage(0).quality;
  EXPECT_LE(quality.stepVoxels, kept.stepVoxels);
  EXPECT_EQ(quality.toleranceLevels, kept.toleranceLevels) << "the road that was chosen";
}

TEST(Refinement, leavesTheEventLoopFree) {
  RefiningHost host({640, 400});
  host.view.setCompareLayout(CompareLayout::sideBySide);
  host.showPhantom(4.0);
  ASSERT_TRUE(host.show());
  // Shaders are compiled in one piece, by a driver in its own time; from the first finer strip on it is ours.
  ASSERT_TRUE(test::waitUntil([&] { return host.view.pictureState().refinementFraction > 0.0; }));
  const test::Heart heart;
  ASSERT_TRUE(host.refined());
  test::expectShortTurns(heart, "while two phantoms are refined", 100.0);
}

TEST(Refinement, ofAFunctionWithANeedleSaysThatItIsNotResolvedUntilItIs) {
  RefiningHost host;
  host.showPhantom();
  host.view.setRefinesAtRest(false);
  host.scene.quality.preintegrated = Preintegration::never;
  host.scene.transferFunction.points = {
      {100.0, {1.0, 0.2, 0.2}, 0.0}, {110.0, {1.0, 0.2, 0.2}, 0.8}, {120.0, {1.0, 0.2, 0.2}, 0.0}};
  host.view.setScene(host.scene);
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(host.rest());
  EXPECT_FALSE(host.view.pictureState().sides[0].isResolved);
  // Pre-integrated steps pass through the needle.
  host.scene.quality.preintegrated = Preintegration::always;
  host.view.setScene(host.scene);
  ASSERT_TRUE(test::waitUntil([&] { return !host.view.pictureState().resting; }));
  ASSERT_TRUE(host.rest());
  EXPECT_TRUE(host.view.pictureState().sides[0].isResolved);
}

TEST(Refinement, estimatesWhatMovesFromSmallPictures) {
  ViewHost host;
  host.showPhantom();
  ASSERT_TRUE(host.show());
  ASSERT_TRUE(test::waitUntil([&] { return host.isIdle(); }));
  const int programs = host.compiledPrograms();
  for (int frame = 0; frame < 10; ++frame) {
    host.scene.camera = orbited(host.scene.camera, 0.05, 0.0);
    host.view.setScene(host.scene);
    const auto side = [&] { return host.view.pictureState().sides[0]; };
    ASSERT_TRUE(test::waitUntil([&] { return side().estimate.has_value(); })) << "frame " << frame;
    EXPECT_TRUE(side().isRough);
    EXPECT_GT(side().estimate->p99_9, 0.0);
  }
  EXPECT_EQ(host.compiledPrograms(), programs) << "a hand must not wait for a shader";
}

} // namespace
} // namespace limn
