// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/TileSchedule.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(TileSchedule, stripsCoverThePictureOnceFromTopToBottom) {
  TileSchedule schedule({300, 201});
  int nextRow = 0;
  while (!schedule.complete()) {
    const PixelRect strip = schedule.next();
    EXPECT_EQ(strip.topLeft, glm::ivec2(0, nextRow));
    EXPECT_EQ(strip.size.x, 300);
    ASSERT_GT(strip.size.y, 0);
    nextRow += strip.size.y;
    schedule.finished(1.0);
  }
  EXPECT_EQ(nextRow, 201);
  EXPECT_EQ(schedule.fraction(), 1.0);
}

TEST(TileSchedule, stripsOfSteadyCostSettleAtTheTarget) {
  TileSchedule schedule({300, 1000});
  double ms = 0.0;
  for (int i = 0; i < 8; ++i) {
    ms = 0.8 * schedule.next().size.y; // 0.8 ms a row: 15 rows take 12 ms
    schedule.finished(ms);
  }
  EXPECT_LE(ms, TileSchedule::targetMs);
  EXPECT_GE(ms, 0.9 * TileSchedule::targetMs);
}

TEST(TileSchedule, aStripAfterEmptyRowsIsAtMostTwiceAsHigh) {
  TileSchedule schedule({300, 1000});
  int last = schedule.next().size.y;
  for (int i = 0; i < 5; ++i) {
    schedule.finished(0.01);
    EXPECT_LE(schedule.next().size.y, 2 * last);
    last = schedule.next().size.y;
  }
  EXPECT_EQ(last, TileSchedule::mostRows);
}

TEST(TileSchedule, aSlowStripIsFollowedByTheLowestOnes) {
  TileSchedule schedule({300, 1000});
  schedule.finished(4000.0);
  EXPECT_EQ(schedule.next().size.y, TileSchedule::leastRows);
  EXPECT_NEAR(schedule.predictedMs(), 4000.0 / TileSchedule::firstRows * TileSchedule::leastRows, 1e-9);
}

TEST(TileSchedule, sumsTheTimeSpent) {
  TileSchedule schedule({10, 20});
  schedule.finished(2.0);
  schedule.finished(3.0);
  EXPECT_EQ(schedule.spentMs(), 5.0);
}

TEST(TileSchedule, anEmptyPictureIsComplete) {
  EXPECT_TRUE(TileSchedule().complete());
  EXPECT_EQ(TileSchedule().fraction(), 1.0);
}

TEST(TileSchedule, aWholePictureAtOnceIsComplete) {
  TileSchedule schedule({10, 20});
  schedule.finishedWhole(7.0);
  EXPECT_TRUE(schedule.complete());
  EXPECT_EQ(schedule.spentMs(), 7.0);
}

} // namespace
} // namespace limn
