// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/controls/Popups.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

const QRect screen(0, 0, 800, 600);
const QSize size(200, 300);

TEST(PopupPlace, isBelowWhereThereIsRoomAndOtherwiseAbove) {
  EXPECT_EQ(popupPlace(size, {100, 50, 20, 20}, screen), QRect(QPoint(100, 74), size)); // 4 pixels apart
  EXPECT_EQ(popupPlace(size, {100, 550, 20, 20}, screen), QRect(QPoint(100, 246), size));
  EXPECT_EQ(popupPlace(size, {780, 50, 20, 20}, screen).right(), screen.right());
}

TEST(PopupPlace, isBesideTheAnchorWhereNeitherHasRoom) {
  const QSize high(200, 400);
  EXPECT_EQ(popupPlace(high, {100, 290, 20, 20}, screen), QRect(QPoint(124, 200), high));
  EXPECT_EQ(popupPlace(high, {700, 290, 20, 20}, screen), QRect(QPoint(496, 200), high));
}

TEST(PopupPlace, neverCoversItsAnchorWhereItFitsBesideIt) {
  for (int x = 0; x <= 780; x += 20)
    for (int y = 0; y <= 580; y += 20) {
      const QRect anchor(x, y, 20, 20);
      for (const QSize& one : {size, QSize(380, 560), QSize(500, 280)}) {
        const QRect place = popupPlace(one, anchor, screen);
        EXPECT_TRUE(screen.contains(place));
        EXPECT_FALSE(place.intersects(anchor)) << x << ' ' << y << ' ' << one.width();
      }
    }
}

TEST(PopupPlace, staysOnTheScreenWhereItFitsNowhere) {
  const QRect place = popupPlace({800, 590}, {400, 10, 20, 20}, screen);
  EXPECT_TRUE(screen.contains(place));
  EXPECT_EQ(place.bottom(), screen.bottom()) << "away from the anchor";
}

} // namespace
} // namespace limn
