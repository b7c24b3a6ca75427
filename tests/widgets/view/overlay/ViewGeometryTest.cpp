// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/overlay/ViewGeometry.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(ViewGeometry, sidesAreEqualWhateverTheWidth) {
  for (const int width : {800, 801}) {
    const auto rects = pictureRects({CompareLayout::sideBySide, 0.5, {width, 300}});
    ASSERT_EQ(rects.size(), 2u);
    EXPECT_EQ(rects[0].size, glm::ivec2(399, 300));
    EXPECT_EQ(rects[1].size, rects[0].size);
    EXPECT_EQ(rects[1].topLeft.x + rects[1].size.x, width);
  }
}

TEST(ViewGeometry, bothPicturesOfAWipeFillTheView) {
  const auto rects = pictureRects({CompareLayout::wipe, 0.5, {800, 300}});
  ASSERT_EQ(rects.size(), 2u);
  EXPECT_EQ(rects[0].size, glm::ivec2(800, 300));
  EXPECT_EQ(rects[1], rects[0]);
}

TEST(ViewGeometry, knowsThePictureUnderAPoint) {
  const auto at = [](CompareLayout layout, double wipe, double x) {
    return positionAt({layout, wipe, {800, 300}}, {x, 10.0});
  };
  EXPECT_EQ(at(CompareLayout::sideBySide, 0.5, 399.0), 0);
  EXPECT_EQ(at(CompareLayout::sideBySide, 0.5, 401.0), 1);
  EXPECT_EQ(at(CompareLayout::wipe, 0.25, 199.0), 0);
  EXPECT_EQ(at(CompareLayout::wipe, 0.25, 200.0), 1);
  EXPECT_EQ(at(CompareLayout::single, 0.25, 700.0), 0);
}

TEST(ViewGeometry, countsPicturesInDevicePixelsAndPlacesThemInLogicalOnes) {
  const ViewGeometry dense{CompareLayout::sideBySide, 0.5, {400, 150}, 2.0};
  EXPECT_EQ(pictureRects(dense)[0].size, glm::ivec2(398, 300)); // (800 - 2 · 2) / 2
  EXPECT_EQ(pictureRect(dense, 1), QRectF(201.0, 0.0, 199.0, 150.0));
  EXPECT_EQ(positionAt(dense, {199.0, 10.0}), 0);
}

TEST(ViewGeometry, theBorderOfAWipeCanBeTakenHoldOfFromBothSides) {
  const ViewGeometry wipe{CompareLayout::wipe, 0.25, {800, 300}};
  EXPECT_TRUE(isOnWipeBorder(wipe, {189.0, 10.0}));
  EXPECT_TRUE(isOnWipeBorder(wipe, {211.0, 10.0}));
  EXPECT_FALSE(isOnWipeBorder(wipe, {230.0, 10.0}));
  EXPECT_FALSE(isOnWipeBorder({CompareLayout::single, 0.25, {800, 300}}, {200.0, 10.0}));
}

TEST(ViewGeometry, hasNoPictureWhereTheViewIsTooSmall) {
  EXPECT_TRUE(pictureRects({CompareLayout::sideBySide, 0.5, {3, 300}}).empty());
  EXPECT_TRUE(pictureRects({CompareLayout::single, 0.5, {0, 0}}).empty());
  EXPECT_EQ(pictureAspect({CompareLayout::single, 0.5, {0, 0}}), 1.0);
}

} // namespace
} // namespace limn
