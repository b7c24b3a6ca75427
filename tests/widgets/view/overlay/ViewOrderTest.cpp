// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/ViewOrder.h"
#include "scene/volume/Phantom.h"
#include "widgets/view/drawing/ViewDrawing.h"

#include <gtest/gtest.h>

// What the view pushes to those who draw, and what is told of it.

namespace limn {
namespace {

class Order : public testing::Test {
protected:
  Order() {
    order.comparison.scene.volume = phantomVolume({12.0, 0.0, 1});
    order.comparison.layout = CompareLayout::wipe;
    order.geometry = {CompareLayout::wipe, 0.5, {400, 300}, 1.0};
    order.isSeen = true;
  }
  // Whether pictures that rest, or do not, would be drawn anew.
  bool draws(const ViewOrder& next, bool isResting) const {
    return asksForOthers(pictureOrderOf(next), pictureOrderOf(order), isResting);
  }

  ViewOrder order;
};

TEST_F(Order, anEqualOneAsksForNothing) {
  const ViewOrder same = order;
  EXPECT_EQ(same, order);
  EXPECT_EQ(pictureOrderOf(same), pictureOrderOf(order));
  EXPECT_FALSE(draws(same, true));
  EXPECT_FALSE(draws(same, false));
}

TEST_F(Order, whatStandsAboveThePicturesIsAnotherOrderOfTheSamePictures) {
  std::vector<ViewOrder> others(8, order);
  others[0].hovered.wipe = true;
  others[1].labelOpacity = 0.5;
  others[2].comparison.markMm = glm::dvec3(1.0);
  others[3].comparison.preview = "Bone";
  others[4].hasCropBox = true;
  others[5].read = ReadValue{100.0, {3.0, 4.0}};
  others[6].measured = std::make_shared<const MeasuredErrors>();
  others[7].hasOverlay = false;
  for (const ViewOrder& other : others) {
    EXPECT_NE(other, order);
    EXPECT_EQ(pictureOrderOf(other), pictureOrderOf(order));
  }
}

TEST_F(Order, theWipeDrawsAnewOnlyWhatWasHiddenWhileItMoved) {
  ViewOrder moved = order;
  moved.comparison.wipe = moved.geometry.wipe = 0.25;
  EXPECT_NE(pictureOrderOf(moved), pictureOrderOf(order));
  EXPECT_FALSE(draws(moved, true));
  EXPECT_TRUE(draws(moved, false));
}

TEST_F(Order, anotherSceneSizeOrAttemptIsDrawnAnew) {
  std::vector<ViewOrder> others(4, order);
  others[0].comparison.scene.camera.position.x += 1.0;
  others[1].geometry.size = {300, 300};
  others[2].attempt = 1;
  others[3].comparison.models[0] = ShadingModel::none;
  for (const ViewOrder& other : others)
    EXPECT_TRUE(draws(other, true));
}

TEST_F(Order, whatIsHiddenAndSeenAgainGoesOnWhereItRests) {
  ViewOrder hidden = order;
  hidden.isSeen = false;
  EXPECT_FALSE(draws(hidden, true));
  EXPECT_TRUE(draws(hidden, false));
}

TEST_F(Order, stateIsToldWithTheEngineAndWhatWasMeasured) {
  PictureState drawn;
  drawn.sides.resize(2);
  drawn.sides[0].stepVoxels = 0.25;
  order.inUse = {Engine::cpu, QStringLiteral("A reason."), true, QStringLiteral("Too large.")};
  order.measured = std::make_shared<const MeasuredErrors>(
      [](const Scene& scene) { return std::optional(scene.quality.stepVoxels); });
  PictureState told = stateTold(drawn, order);
  EXPECT_EQ(told.engine, Engine::cpu);
  EXPECT_EQ(told.engineReason, QStringLiteral("A reason."));
  EXPECT_TRUE(told.driverHasFailed);
  EXPECT_EQ(told.limitation, QStringLiteral("Too large."));
  EXPECT_FALSE(told.sides[0].measuredLevels) << "nothing was measured of what moves";
  drawn.resting = true;
  told = stateTold(drawn, order);
  EXPECT_EQ(told.sides[0].measuredLevels, 0.25) << "of the step on screen";
}

TEST_F(Order, ofStalePicturesNothingIsComplete) {
  PictureState state;
  state.sides.resize(1);
  state.sides[0].fraction = 1.0;
  state.sides[0].completeMs = 12.0;
  state.resting = state.refines = true;
  state.refinementEnd = RefinementEnd::patience;
  const PictureState stale = staleState(state);
  EXPECT_FALSE(stale.resting || stale.refines || stale.refinementEnd);
  EXPECT_EQ(stale.sides[0].fraction, 0.0);
  EXPECT_EQ(stale.sides[0].completeMs, 12.0) << "what the last complete picture took";
}

} // namespace
} // namespace limn
