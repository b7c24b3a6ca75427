// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/TileSchedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

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
    ms = 0.75 * schedule.next().size.y; // 0.75 ms a row: 16 rows take 12 ms
    schedule.finished(ms);
  }
  EXPECT_LE(ms, TileSchedule::usualMs);
  EXPECT_GE(ms, 0.9 * TileSchedule::usualMs);
}

TEST(TileSchedule, stripsThatHoldUpNobodyMayBeLonger) {
  constexpr double ms = 4.0 * TileSchedule::usualMs;
  TileSchedule schedule({300, 1000}, ms);
  EXPECT_EQ(schedule.next().size.y, 4 * TileSchedule::firstRows);
  double last = 0.0;
  for (int strip = 0; strip < 4; ++strip) {
    last = 0.25 * schedule.next().size.y; // a quarter of a millisecond a row
    schedule.finished(last);
  }
  EXPECT_LE(last, ms);
  EXPECT_GE(last, 0.9 * ms);
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

TEST(TileSchedule, aSlowStripIsFollowedByTheSmallestOnes) {
  TileSchedule schedule({300, 1000});
  schedule.finished(4000.0);
  EXPECT_EQ(schedule.next().size, glm::ivec2(TileSchedule::leastColumns, TileSchedule::leastRows));
  const double pixels = TileSchedule::leastColumns * TileSchedule::leastRows;
  EXPECT_NEAR(schedule.predictedMs(), 4000.0 / (TileSchedule::firstRows * 300.0) * pixels, 1e-9);
}

TEST(TileSchedule, stripsThatAreCutCoverThePictureOnce) {
  const glm::ivec2 size(301, 11);
  TileSchedule schedule(size);
  std::vector<int> drawn(static_cast<std::size_t>(size.x) * size.y, 0);
  double fraction = 0.0;
  while (!schedule.complete()) {
    const PixelRect tile = schedule.next();
    int lowest = tile.topLeft.y;
    for (int y = tile.topLeft.y; y < tile.topLeft.y + tile.size.y; ++y)
      for (int x = tile.topLeft.x; x < tile.topLeft.x + tile.size.x; ++x)
        ++drawn[static_cast<std::size_t>(y) * size.x + x];
    EXPECT_LE(schedule.rowsDone(), lowest) << "rows count once they are drawn over the whole width";
    schedule.finished(0.05 * tile.size.x * tile.size.y); // 30 ms for two whole rows
    EXPECT_GT(schedule.fraction(), fraction);
    fraction = schedule.fraction();
  }
  EXPECT_EQ(drawn, std::vector<int>(drawn.size(), 1));
  EXPECT_EQ(schedule.fraction(), 1.0);
}

TEST(TileSchedule, cutStripsOfSteadyCostSettleAtTheTarget) {
  TileSchedule schedule({1000, 1000});
  double ms = 0.0;
  for (int i = 0; i < 60; ++i) {
    ms = 0.012 * schedule.next().size.x * schedule.next().size.y; // 1000 pixels take 12 ms
    schedule.finished(ms);
    if (schedule.rowsDone() > TileSchedule::firstRows) {
      EXPECT_LE(ms, TileSchedule::usualMs + 1e-9);
    }
  }
}

// Rows of a head between rows of air: 0.01 ms each, then 6 ms each.
std::vector<double> headBetweenAir() {
  std::vector<double> rows(300, 0.01);
  std::fill(rows.begin() + 100, rows.begin() + 200, 6.0);
  return rows;
}

TEST(TileSchedule, stripsBeforeRowsThatAreKnownToBeSlowAreLowInTime) {
  const std::vector<double> rows = headBetweenAir();
  TileSchedule schedule({400, 300}, TileSchedule::usualMs, rows);
  double longest = 0.0;
  int strips = 0;
  for (; !schedule.complete(); ++strips) {
    const PixelRect strip = schedule.next();
    double ms = 0.0;
    for (int y = strip.topLeft.y; y < strip.topLeft.y + strip.size.y; ++y)
      ms += rows[static_cast<std::size_t>(y)] * strip.size.x / 400.0;
    EXPECT_GE(schedule.predictedMs(), ms - 1e-9);
    longest = std::max(longest, ms);
    schedule.finished(ms);
  }
  EXPECT_LE(longest, TileSchedule::usualMs + 1e-9);
  EXPECT_LE(strips, 140) << "the head takes 600 ms";
  double all = 0.0;
  for (const double ms : schedule.rowMs())
    all += ms;
  EXPECT_NEAR(all, 602.0, 1e-9);
  EXPECT_NEAR(schedule.rowMs()[150], 6.0, 1e-9);
}

TEST(TileSchedule, stripsEndWhereWholeBlocksOfTheRendererAreLeftBelow) {
  TileSchedule schedule({300, 203});
  for (int i = 0; !schedule.complete(); ++i) {
    if (i > 1) {
      EXPECT_EQ((203 - schedule.next().topLeft.y) % TileSchedule::leastRows, 0) << "strip " << i;
    }
    schedule.finished(0.3 * i);
  }
}

TEST(TileSchedule, learnsThatAllTakesLongerThanExpected) {
  TileSchedule schedule({400, 300}, TileSchedule::usualMs, std::vector<double>(300, 1.0));
  double ms = 0.0;
  for (int i = 0; i < 12; ++i) {
    ms = 3.0 * schedule.next().size.y;
    schedule.finished(ms);
  }
  EXPECT_LE(ms, 1.2 * TileSchedule::usualMs);
}

TEST(TileSchedule, aPictureDrawnAtOnceIsExpectedToBeEven) {
  TileSchedule schedule({10, 20});
  schedule.finishedWhole(8.0);
  EXPECT_EQ(schedule.rowMs(), std::vector<double>(20, 0.4));
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
