// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/saving/DrawingTime.h"
#include "scene/light/LightPresets.h"
#include "widgets/controls/TimeLeft.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

Scene physicalScene(const Until& until) {
  Scene scene;
  scene.shading.model = ShadingModel::physical;
  scene.shading.physical.until = until;
  return scene;
}

// 32 paths a pixel with an error of 4 levels, each of which took 10 ms.
SideState shownPaths() {
  SideState side;
  side.paths = PathFigures{32, 4.0, 12.0, {}};
  side.msPerPath = 10.0;
  side.completeMs = 160.0; // the last 16
  return side;
}

TEST(DrawingTime, ofPathsIsTheirsTimesThePixels) {
  EXPECT_DOUBLE_EQ(*secondsToDraw(physicalScene(UntilPaths{256}), shownPaths(), 4.0), 4.0 * 2.56);
  // Half of the error takes four times as many paths.
  EXPECT_DOUBLE_EQ(*secondsToDraw(physicalScene(UntilLevels{2.0}), shownPaths(), 1.0), 128 * 0.010);
  EXPECT_DOUBLE_EQ(*secondsToDraw(physicalScene(UntilSeconds{7.0}), shownPaths(), 4.0), 7.0);
  EXPECT_DOUBLE_EQ(*secondsToDraw(physicalScene(UntilSeconds{7.0}), shownPaths(), 1000.0), 1000 * 0.040)
      << "four paths take longer than that";
  Scene filtered = physicalScene(UntilPaths{256});
  filtered.shading.physical.filtersNoise = true;
  EXPECT_DOUBLE_EQ(*secondsToDraw(filtered, shownPaths(), 1.0), 2.56 / 0.8) << "the filter is a fifth of all";
  SideState unknown = shownPaths();
  unknown.msPerPath.reset();
  EXPECT_FALSE(secondsToDraw(physicalScene(UntilPaths{256}), unknown, 1.0));
}

TEST(DrawingTime, ofRaysIsThatOfTheScreenTimesThePixels) {
  SideState side;
  EXPECT_FALSE(secondsToDraw(Scene(), side, 4.0));
  side.completeMs = 500.0;
  side.fraction = 1.0;
  EXPECT_DOUBLE_EQ(*secondsToDraw(Scene(), side, 4.0), 2.0);
  side.fraction = 0.9;
  EXPECT_FALSE(secondsToDraw(Scene(), side, 4.0)) << "that is of the picture before";
}

TEST(DrawingTime, ofATurntableIsToldOnceItIsKnown) {
  SideState side;
  side.completeMs = 500.0; // of the picture before
  side.fraction = 0.5;
  EXPECT_EQ(framesTimeText(Scene(), Engine::rayCaster, side, 1.0, 90),
            QStringLiteral("How long drawing takes is known once the picture is complete."));
  side.fraction = 1.0;
  EXPECT_EQ(framesTimeText(Scene(), Engine::rayCaster, side, 1.0, 90),
            QStringLiteral("Drawing takes %1.").arg(aboutText(45.0)));
  EXPECT_EQ(framesTimeText(Scene(), Engine::rayCaster, side, 1.0, 2), QString());
}

// What the screen took says nothing of the light, which it found once.
TEST(DrawingTime, ofATurntableWhoseLampTurnsWithThePictureIsNotKnown) {
  Scene scene;
  SideState side;
  side.completeMs = 500.0;
  side.fraction = 1.0;
  scene.shading = withLight(scene.shading, LightPreset::softStudio);
  EXPECT_TRUE(findsLightForEachView(scene, Engine::rayCaster));
  EXPECT_EQ(framesTimeText(scene, Engine::rayCaster, side, 1.0, 90),
            QStringLiteral("How long drawing takes is not known: light is found anew for each frame."));
  scene.shading.lightAxes = LightAxes::world;
  EXPECT_FALSE(findsLightForEachView(scene, Engine::rayCaster));
  scene.shading = withLight(scene.shading, LightPreset::headlight);
  EXPECT_FALSE(findsLightForEachView(scene, Engine::rayCaster));
}

// The processor follows paths with each picture, so that the screen's took as long; on a grid it does not.
TEST(DrawingTime, ofATurntableWhoseLampTurnsIsThatOfTheScreenWhereLightIsFoundAlongPaths) {
  Scene scene;
  scene.shading = withLight(scene.shading, LightPreset::softStudio);
  SideState side;
  side.completeMs = 500.0;
  side.fraction = 1.0;
  EXPECT_EQ(framesTimeText(scene, Engine::cpu, side, 1.0, 90),
            QStringLiteral("Drawing takes %1.").arg(aboutText(45.0)));
  scene.quality.toleranceLevels = 1.0;
  EXPECT_FALSE(findsLightForEachView(scene, Engine::cpu)) << "for each sample";
  scene.quality.toleranceLevels.reset();
  scene.quality.light = LightDetail::fine;
  EXPECT_TRUE(findsLightForEachView(scene, Engine::cpu));
}

TEST(DrawingTime, onlyWhatTheScreenHasAlreadyIsSavedAsItIs) {
  EXPECT_TRUE(isAsSaved(Scene(), SideState()));
  EXPECT_TRUE(isAsSaved(physicalScene(UntilPaths{32}), shownPaths()));
  EXPECT_FALSE(isAsSaved(physicalScene(UntilPaths{33}), shownPaths()));
  EXPECT_TRUE(isAsSaved(physicalScene(UntilLevels{4.0}), shownPaths()));
  EXPECT_FALSE(isAsSaved(physicalScene(UntilLevels{3.9}), shownPaths()));
  EXPECT_FALSE(isAsSaved(physicalScene(UntilSeconds{1.0}), shownPaths())) << "of the screen's nobody knows";
  Scene filtered = physicalScene(UntilPaths{1});
  filtered.shading.physical.filtersNoise = true;
  EXPECT_FALSE(isAsSaved(filtered, shownPaths()));
}

TEST(DrawingTime, pathsAreToldInWords) {
  PhysicalLight light;
  EXPECT_EQ(savedPathsText(light), QStringLiteral("256 paths a pixel"));
  light.filtersNoise = true;
  EXPECT_EQ(savedPathsText(light), QStringLiteral("256 paths a pixel, noise filtered"));
}

} // namespace
} // namespace limn
