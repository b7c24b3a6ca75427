// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/CameraHistory.h"

#include <gtest/gtest.h>

// Back to where one looked from before, a gesture at a time.

namespace limn {
namespace {

SeenFrom at(double x) {
  SeenFrom seen;
  seen.camera.position.x = x;
  return seen;
}

TEST(CameraHistory, aGestureOfManyMovesIsOneStep) {
  CameraHistory history;
  history.note(at(0), at(1).camera, 7);
  history.note(at(1), at(2).camera, 7);
  history.note(at(2), at(3).camera, 8);
  EXPECT_EQ(history.back(at(3)), at(2));
  EXPECT_EQ(history.back(at(2)), at(0));
  EXPECT_FALSE(history.canGoBack());
  EXPECT_EQ(history.back(at(0)), std::nullopt);
  EXPECT_EQ(history.forward(at(0)), at(2));
  EXPECT_EQ(history.forward(at(2)), at(3));
  EXPECT_EQ(history.forward(at(3)), std::nullopt);
}

TEST(CameraHistory, oneThatComesBackToItsStartLeavesNoStep) {
  CameraHistory history;
  history.note(at(0), at(1).camera, 7);
  history.note(at(1), at(2).camera, 8);
  history.note(at(2), at(1).camera, 8); // Esc
  EXPECT_EQ(history.back(at(1)), at(0));
  EXPECT_FALSE(history.canGoBack());
  history.note(at(0), at(0).camera, 9);
  EXPECT_FALSE(history.canGoBack()) << "nothing moved";
  EXPECT_TRUE(history.canGoForward()) << "nor did the way forward end";
}

TEST(CameraHistory, aNewStepEndsTheWayForwardAlsoOfTheGestureThatWasTakenBack) {
  CameraHistory history;
  history.note(at(0), at(1).camera, 7);
  ASSERT_EQ(history.back(at(1)), at(0));
  ASSERT_TRUE(history.canGoForward());
  history.note(at(0), at(2).camera, 7);
  EXPECT_FALSE(history.canGoForward());
  EXPECT_EQ(history.back(at(2)), at(0));
}

TEST(CameraHistory, keepsTheLatestStepsAndNoMore) {
  CameraHistory history;
  const int steps = static_cast<int>(CameraHistory::mostSteps) + 10;
  for (int step = 0; step < steps; ++step)
    history.note(at(step), at(step + 1).camera, static_cast<std::uint64_t>(step) + 1);
  SeenFrom now = at(steps);
  int taken = 0;
  while (const auto there = history.back(now)) {
    now = *there;
    ++taken;
  }
  EXPECT_EQ(taken, static_cast<int>(CameraHistory::mostSteps));
  EXPECT_EQ(now, at(10)) << "the ten oldest are forgotten";
  history.clear();
  EXPECT_EQ(history, CameraHistory());
}

TEST(GestureRuns, goOnWithTheSameCauseUntilAPause) {
  GestureRuns runs;
  const auto first = runs.idOf(1, 0);
  EXPECT_EQ(runs.idOf(1, GestureRuns::longestPauseMs), first);
  const auto other = runs.idOf(2, GestureRuns::longestPauseMs);
  EXPECT_NE(other, first);
  const auto later = runs.idOf(2, 2 * GestureRuns::longestPauseMs + 1);
  EXPECT_NE(later, other) << "a pause";
  EXPECT_NE(runs.idOf(2, 0), later) << "a clock set back";
}

} // namespace
} // namespace limn
