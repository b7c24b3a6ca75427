// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/ImageError.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace limn {
namespace {

TEST(ErrorMap, tellsTheLargestDifferenceOfEachCoveredPixelInLevels) {
  Image picture({4, 1});
  picture.at(0, 0) = {0.5f, 0.25f, 0.0f, 0.5f};
  picture.at(2, 0) = {0.0f, 0.0f, 0.0f, 1.0f};
  picture.at(3, 0) = glm::vec4(std::numeric_limits<float>::quiet_NaN());
  PrecisePixels exact = precise(picture);
  exact[0].g += 2.0 / 255.0;
  exact[0].a -= 3.0 / 255.0;
  exact[3] = glm::dvec4(0.5);
  const ErrorMap map = errorMap(picture, exact);
  EXPECT_EQ(map.size, glm::ivec2(4, 1));
  EXPECT_NEAR(map.levels[0], 3.0, 1e-5) << "single precision";
  EXPECT_LT(map.levels[1], 0.0f) << "neither picture covers it";
  EXPECT_EQ(map.levels[2], 0.0f);
  EXPECT_TRUE(std::isinf(map.levels[3])) << "what is no number is infinitely wrong";
}

TEST(ErrorMap, agreesWithTheFiguresOfTheWholePicture) {
  Image picture({16, 16});
  PrecisePixels exact(256);
  for (int i = 0; i < 256; ++i) {
    picture.at(i % 16, i / 16) = glm::vec4(0.5f);
    exact[static_cast<std::size_t>(i)] = glm::dvec4(0.5 + i / 255.0 / 64.0);
  }
  const ErrorMap map = errorMap(picture, exact);
  const ImageError error = imageError(picture, exact);
  EXPECT_NEAR(*std::max_element(map.levels.begin(), map.levels.end()), error.largest, 1e-4);
  const auto over = std::count_if(map.levels.begin(), map.levels.end(), [](float l) { return l > 1.0f; });
  EXPECT_EQ(static_cast<double>(over) / 256.0, error.shareOverOne);
}

} // namespace
} // namespace limn
