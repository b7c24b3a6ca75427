// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of physical light until paths, levels or seconds are reached, and what they tell of themselves;
// and how far pictures of rays tell that they are.
#include "app/core/drawing/PathDrawing.h"
#include "app/core/drawing/PathAccuracy.h"
#include "app/core/drawing/PictureMaker.h"
#include "app/core/drawing/StatedAccuracy.h"
#include "scene/basics/Error.h"
#include "scene/effects/EffectPlan.h"
#include "scene/light/LightPresets.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace limn {
namespace {

constexpr glm::ivec2 fewPixels{20, 16};

Scene pathScene(const Until& until) {
  static const auto volume = phantomVolume({.spacingMm = 8.0});
  Scene scene = headScene(volume, ShadingModel::physical);
  scene.shading.physical.until = until;
  return scene;
}

TEST(PathDrawing, aQualityWithPathsGoesBeforeTheScenesOwnEnd) {
  Scene scene = pathScene(UntilPaths{256});
  scene.quality.paths = 8; // as a picture on screen has
  const MadePicture picture = makePictures({scene}, fewPixels, Engine::cpu, 2).front();
  ASSERT_TRUE(picture.paths);
  EXPECT_EQ(picture.paths->paths, 8);
  // What is written down draws the same again.
  EXPECT_EQ(picture.scene.shading.physical.until, Until(UntilPaths{8}));
  EXPECT_FALSE(picture.scene.quality.paths);
  EXPECT_EQ(makePictures({picture.scene}, fewPixels, Engine::cpu, 2).front().image, picture.image);
  EXPECT_NE(exactnessOf(picture).find("after 8 paths a pixel"), std::string::npos) << exactnessOf(picture);
}

TEST(NoteBeyondTolerance, saysThatPixelsLieFartherOffAndWhatToAskFor) {
  Scene scene = pathScene(UntilPaths{1});
  EXPECT_TRUE(noteBeyondTolerance(scene, {9.0, 0.0, 9.0, chancePixels}).empty()) << "nothing was asked for";
  scene.quality.toleranceLevels = 0.5;
  EXPECT_TRUE(noteBeyondTolerance(scene, {0.5, 0.0, 0.5, chancePixels}).empty()) << "it is kept";
  const std::string note = noteBeyondTolerance(scene, {0.67, 0.0, 0.6, chancePixels}).english();
  EXPECT_NE(note.find("farther off than the tolerance of 0.5 levels"), std::string::npos) << note;
  EXPECT_NE(note.find("--tolerance 0.37"), std::string::npos) << note;
}

TEST(PathDrawing, aPictureThatMemoryDoesNotHoldIsRefusedInASentence) {
  CpuRenderer renderer(1);
  const Scene scene = pathScene(UntilPaths{1});
  constexpr glm::ivec2 size{1 << 20, 1 << 20}; // 79 TB
  const std::vector<std::function<void()>> works{[&] { drawnByPaths(renderer, scene, size, {}); },
                                                 [&] { measurePaths("head", scene, size, 8, {}); },
                                                 [&] { pathErrors(scene, size, {}); }};
  for (const std::function<void()>& work : works)
    try {
      work();
      FAIL() << "drawn";
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("79164.8 GB of what its paths find"), std::string::npos)
          << error.what();
    }
}

TEST(PathDrawing, errorOverPathsIsThatOfThePicturesAndFallsByItsLaw) {
  const Scene scene = pathScene(UntilPaths{256});
  const AccuracyReport report = measurePaths("head", scene, fewPixels, 64, {2, {}, {}});
  ASSERT_EQ(report.points.size(), 5u); // 4, 8, 16, 32, 64
  const PathErrors last = [&] {
    Scene drawn = scene;
    drawn.quality.paths = 64;
    return pathErrors(drawn, fewPixels, {2, {}, {}});
  }();
  ASSERT_TRUE(last.error);
  EXPECT_EQ(report.points.back().error, *last.error);
  EXPECT_EQ(last.map.size, fewPixels);
  EXPECT_EQ(*std::ranges::max_element(last.map.levels), static_cast<float>(last.error->largest));
  // From 16 to 64 paths half of the error; from few pixels and paths it is known to some ten per cent.
  EXPECT_NEAR(report.points[4].error.rms / report.points[2].error.rms, 0.5, 0.1);
  ASSERT_EQ(report.remarks.size(), 1u);
  EXPECT_NE(report.remarks[0].find("1024 paths"), std::string::npos) << report.remarks[0];
  EXPECT_THROW(measurePaths("head", scene, fewPixels, 64, {2, [] { return true; }, {}}), Cancelled);
}

TEST(PathDrawing, whereAPictureIsOffTellsHowFarItIsAndEndsWhenAsked) {
  const Scene scene = pathScene(UntilPaths{64});
  std::vector<double> fractions;
  const PathErrors whole = pathErrors(
      scene, fewPixels, {2, {}, {}}, [&](double fraction, const Message&) { fractions.push_back(fraction); });
  // 64 paths in 16 passes.
  ASSERT_EQ(fractions.size(), 16u);
  for (std::size_t i = 0; i < fractions.size(); ++i)
    EXPECT_EQ(fractions[i], static_cast<double>(i) / 16.0);
  // Passes change nothing.
  CpuRenderer renderer(2);
  renderer.draw(scene, fewPixels, {{0, 0}, fewPixels});
  EXPECT_EQ(whole.map.levels, renderer.pathErrors(scene, fewPixels));
  int told = 0;
  const Effort untilAsked{2, [&told] { return told >= 3; }, {}};
  EXPECT_THROW(pathErrors(scene, fewPixels, untilAsked, [&told](double, const Message&) { ++told; }),
               Cancelled);
  EXPECT_EQ(told, 3);
}

// One path differs from none other: no error of 0.
TEST(PathDrawing, theErrorOfASinglePathIsNotKnown) {
  EXPECT_FALSE(pathErrors(pathScene(UntilPaths{1}), fewPixels, {2, {}, {}}).error);
  EXPECT_TRUE(pathErrors(pathScene(UntilPaths{2}), fewPixels, {2, {}, {}}).error);
  Scene nothing = pathScene(UntilPaths{1});
  for (ControlPoint& point : nothing.transferFunction.points)
    point.opacity = 0.0;
  EXPECT_EQ(pathErrors(nothing, fewPixels, {2, {}, {}}).error, ImageError{});
}

TEST(PathDrawing, tellsWithinAPassHowMuchOfItsTimeWent) {
  CpuRenderer renderer(2);
  std::vector<double> told;
  const Effort effort{2, {}, [&told](double fraction) { told.push_back(fraction); }};
  const DrawnByPaths drawn = drawnByPaths(renderer, pathScene(UntilSeconds{1e-6}), {128, 128}, effort);
  EXPECT_EQ(drawn.figures.paths, 4) << "the first pass took all of it";
  ASSERT_GT(told.size(), 2u);
  EXPECT_TRUE(std::ranges::is_sorted(told));
  EXPECT_LT(told.at(told.size() - 2), 1.0);
  EXPECT_EQ(told.back(), 1.0) << "it is there";
}

// How far the processor's pictures are is told of in `told`.
MakingOptions tellingOf(std::vector<double>& told) {
  MakingOptions order;
  order.engine = Engine::cpu;
  order.effort.threads = 2;
  order.effort.report = [&told](double fraction) { told.push_back(fraction); };
  return order;
}

// The pictures from which steps are found are none of those that are asked for.
TEST(PictureProgress, neverGoesBack) {
  Scene scene = headScene(phantomVolume({.spacingMm = 8.0}), ShadingModel::classic);
  scene.quality.toleranceLevels = 0.5;
  std::vector<double> told;
  const MakingOptions order = tellingOf(told);
  constexpr glm::ivec2 severalStrips{16, 400};
  makeEach({scene, scene}, severalStrips, order, [](std::size_t, const MadePicture&) {});
  ASSERT_GE(told.size(), 4u) << "two strips of each at least";
  EXPECT_EQ(std::ranges::adjacent_find(told, std::ranges::greater_equal()), told.end()) << "each strip once";
  EXPECT_EQ(told.back(), 1.0);
}

// A film of small frames goes on by frames, of which it is known how long the rest takes.
TEST(PictureProgress, tellsEachSmallPictureThatIsDrawn) {
  const Scene scene = headScene(phantomVolume({.spacingMm = 8.0}), ShadingModel::classic);
  std::vector<double> told;
  const MakingOptions order = tellingOf(told);
  makeEach({scene, scene}, fewPixels, order, [](std::size_t, const MadePicture&) {});
  EXPECT_EQ(told, (std::vector<double>{0.5, 1.0}));
}

// What the light that is looked up adds is told where somebody asks; drawing it takes two pictures more.
TEST(PictureMaker, drawsNoOtherPicturesBesideOneThatTellsNothingOfThem) {
  Scene scene = headScene(phantomVolume({.spacingMm = 8.0}), ShadingModel::enhanced);
  scene.shading = withLight(scene.shading, LightPreset::softStudio);
  ASSERT_TRUE(hasTravellingLight(scene));
  int drawn = 0;
  const auto draw = [&drawn](const Scene&, const glm::ivec2& size) {
    ++drawn;
    Image picture;
    picture.size = size;
    picture.pixels.resize(static_cast<std::size_t>(size.x) * size.y);
    return picture;
  };
  pictureDrawnBy(draw, scene, fewPixels, "test");
  EXPECT_EQ(drawn, 1);
  MakingOptions order;
  order.engine = Engine::cpu;
  order.effort.threads = 2;
  for (const bool tells : {false, true}) {
    order.tellsFilter = tells;
    makeEach({scene}, fewPixels, order, [tells](std::size_t, const MadePicture& picture) {
      EXPECT_EQ(picture.ofFilter != ImageError(), tells);
    });
  }
}

// As a picture of two sides is saved: the first ends, and the second begins, in the middle of the way.
TEST(PictureProgress, eachOfTwoHasItsHalf) {
  const Scene scene = headScene(phantomVolume({.spacingMm = 8.0}), ShadingModel::classic);
  std::vector<double> told;
  const MakingOptions order = tellingOf(told);
  constexpr glm::ivec2 severalStrips{16, 400};
  std::vector<double> atTheEnd;
  makeEach({scene, scene}, severalStrips, order,
           [&](std::size_t, const MadePicture&) { atTheEnd.push_back(told.back()); });
  EXPECT_EQ(atTheEnd, (std::vector<double>{0.5, 1.0}));
  const auto isOfTheFirst = [](double fraction) { return fraction < 0.5; };
  EXPECT_TRUE(std::ranges::is_partitioned(told, isOfTheFirst));
  EXPECT_GE(std::ranges::count_if(told, isOfTheFirst), 2) << "strips of the first";
}

// Files refuse levels that no picture is off by.
TEST(StatedAccuracy, anEstimateSaysThatItIsOneAndStaysWithinWhite) {
  const PictureAccuracy told = accuracyByEstimate(0.411);
  EXPECT_EQ(told.levels, 0.411);
  EXPECT_EQ(told.sentence,
            "99.9 % of the pixels are estimated to lie within 0.42 of 255 levels of the exact picture.");
  EXPECT_EQ(accuracyByEstimate(1000.0).levels, 255.0);
}

} // namespace
} // namespace limn
