// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/SamplePicture.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

// The relative luminance of an sRGB colour (IEC 61966-2-1).
double luminance(const glm::dvec3& color) {
  const auto linear = [](double x) { return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4); };
  return 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
}

TEST(SamplePicture, figuresLeaveOutPixelsWithoutSamples) {
  EXPECT_EQ(figuresOf({0, 4, 0, 8}), (SampleFigures{4, 8, 6.0}));
  EXPECT_EQ(figuresOf({0, 0}), SampleFigures{});
}

TEST(SamplePicture, theScaleGrowsBrighterThroughout) {
  double before = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const double here = luminance(colorOfShare(i / 100.0));
    EXPECT_GT(here, before) << i;
    before = here;
  }
  EXPECT_GT(before, 0.7);
}

TEST(SamplePicture, itsBrightnessFollowsTheShareOfTheMost) {
  const Image image = pictureOfSamples({0, 1, 20, 40}, {4, 1});
  EXPECT_EQ(image.pixels[0], glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
  EXPECT_EQ(image.pixels[1], glm::vec4(glm::vec3(colorOfShare(1.0 / 40.0)), 1.0f));
  EXPECT_EQ(image.pixels[2], glm::vec4(glm::vec3(colorOfShare(0.5)), 1.0f));
  EXPECT_EQ(image.pixels[3], glm::vec4(glm::vec3(colorOfShare(1.0)), 1.0f));
}

} // namespace
} // namespace limn
