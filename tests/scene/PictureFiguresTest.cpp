// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/PictureFigures.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

Image pictureOf(std::vector<glm::vec4> pixels) {
  Image image({static_cast<int>(pixels.size()), 1});
  image.pixels = std::move(pixels);
  return image;
}

TEST(PictureFigures, overflowCountsCoveredPixelsWithAChannelOverOne) {
  const Overflow overflow = overflowOf(pictureOf(
      {{1.5f, 0.2f, 0.0f, 1.0f}, {0.9f, 1.0f, 0.3f, 1.0f}, {0.1f, 0.1f, 1.25f, 0.5f}, {0, 0, 0, 0}}));
  EXPECT_DOUBLE_EQ(overflow.share, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(overflow.meanOvershoot, (0.5 + 0.25) / 2.0);
  EXPECT_EQ(overflowOf(pictureOf({{0.9f, 0.9f, 0.9f, 1.0f}})), Overflow{});
  EXPECT_EQ(overflowOf(pictureOf({})), Overflow{});
}

TEST(PictureFigures, contrastIsTheDeviationOfTheLuminanceOfCoveredPixels) {
  // Luminances 0 and 1 deviate by a half; uncovered pixels change nothing.
  EXPECT_NEAR(contrastOf(pictureOf({{0, 0, 0, 1}, {1, 1, 1, 1}, {0, 0, 0, 0}})), 0.5, 1e-7);
  EXPECT_EQ(contrastOf(pictureOf({{0.5f, 0.5f, 0.5f, 1}, {0.5f, 0.5f, 0.5f, 1}})), 0.0);
  EXPECT_EQ(contrastOf(pictureOf({{0, 0, 0, 0}})), 0.0);
}

TEST(PictureFigures, theVisibleShareIsTheMeanWeightWhereTheTissueIsMet) {
  const Image weights =
      pictureOf({{0.5f, 0.5f, 0.5f, 0.9f}, {0.1f, 0.1f, 0.1f, 1.0f}, {0.7f, 0.7f, 0.7f, 1.0f}});
  EXPECT_NEAR(visibleShare(weights, pictureOf({{1, 1, 1, 1}, {1, 1, 1, 1}, {0, 0, 0, 0}})), 0.3, 1e-7);
  EXPECT_EQ(visibleShare(weights, pictureOf({{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}})), 0.0);
}

TEST(PictureFigures, theTissueIsWhiteFromTheIsovalueOnAndOpacityStays) {
  Scene scene;
  scene.isovalue = 300.0;
  scene.transferFunction = {1.0, {{0.0, {1.0, 0.0, 0.0}, 0.1}, {1000.0, {0.0, 1.0, 0.0}, 0.6}}};
  const TransferFunction function = tissueScenes(scene).weights.transferFunction;
  for (const double value : {-10.0, 0.0, 150.0, 299.0, 300.0, 301.0, 700.0, 2000.0}) {
    const Classified classified = classify(function, value);
    EXPECT_NEAR(classified.opacity, classify(scene.transferFunction, value).opacity, 1e-12) << value;
    EXPECT_EQ(classified.color, glm::dvec3(value < 300.0 ? 0.0 : 1.0)) << value;
  }
  scene.transferFunction.points.insert(scene.transferFunction.points.begin() + 1,
                                       {300.0, {0.0, 0.0, 1.0}, 0.2});
  const TransferFunction atPoint = tissueScenes(scene).weights.transferFunction;
  EXPECT_EQ(classify(atPoint, 299.9).color, glm::dvec3(0.0));
  EXPECT_EQ(classify(atPoint, 300.0).color, glm::dvec3(1.0));
  // All points on one side of the isovalue.
  scene.isovalue = 5000.0;
  EXPECT_EQ(classify(tissueScenes(scene).weights.transferFunction, 4000.0).color, glm::dvec3(0.0));
  scene.isovalue = -5000.0;
  EXPECT_EQ(classify(tissueScenes(scene).weights.transferFunction, -4000.0).color, glm::dvec3(1.0));
}

} // namespace
} // namespace limn
