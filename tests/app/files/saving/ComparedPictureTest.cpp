// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/saving/ComparedPicture.h"

#include "app/core/drawing/ComparedSides.h"

#include <gtest/gtest.h>

// What is saved of two pictures: what the layout shows.

namespace limn {
namespace {

Image filled(const glm::ivec2& size, const glm::vec4& pixel) {
  Image image(size);
  image.pixels.assign(image.pixels.size(), pixel);
  return image;
}

const Image red = filled({4, 2}, {0.5f, 0.0f, 0.0f, 1.0f});
const Image green = filled({4, 2}, {0.0f, 0.25f, 0.0f, 0.5f});
const glm::dvec3 grey(0.5);

TEST(ComparedPicture, aWipeIsPartedWhereItIsOnScreen) {
  const Image parted = comparedPicture(red, green, CompareLayout::wipe, 0.75, grey);
  ASSERT_EQ(parted.size, red.size);
  EXPECT_EQ(parted.at(2, 1), red.at(2, 1));
  EXPECT_EQ(parted.at(3, 1), green.at(3, 1));
  EXPECT_EQ(comparedPicture(red, green, CompareLayout::wipe, 0.0, grey), green);
  EXPECT_EQ(comparedPicture(red, green, CompareLayout::wipe, 1.0, grey), red);
}

TEST(ComparedPicture, sidesStandBesideEachOther) {
  const Image joined = comparedPicture(red, green, CompareLayout::sideBySide, 0.5, grey);
  ASSERT_EQ(joined.size, glm::ivec2(8, 2));
  EXPECT_EQ(joined.at(3, 0), red.at(3, 0));
  EXPECT_EQ(joined.at(4, 0), green.at(0, 0));
}

TEST(ComparedPicture, aDifferenceHasTheColourOfTheBrighterSide) {
  // Over grey the green picture is (0.25, 0.5, 0.25): green is half a unit brighter than in the red one,
  // which four times is more than the whole colour.
  const Image difference = comparedPicture(red, green, CompareLayout::difference, 0.5, grey);
  EXPECT_EQ(difference.at(0, 0), glm::vec4(glm::vec3(rightBrighterColor), 1.0f));
  EXPECT_EQ(comparedPicture(green, red, CompareLayout::difference, 0.5, grey).at(0, 0),
            glm::vec4(glm::vec3(leftBrighterColor), 1.0f));
  EXPECT_EQ(comparedPicture(red, red, CompareLayout::difference, 0.5, grey).at(0, 0),
            glm::vec4(0.0f, 0.0f, 0.0f, 1.0f));
  const Image little = filled({4, 2}, {0.55f, 0.0f, 0.0f, 1.0f});
  EXPECT_NEAR(comparedPicture(red, little, CompareLayout::difference, 0.5, grey).at(0, 0).r, 0.2f, 1e-5)
      << "0.05 times four";
}

} // namespace
} // namespace limn
