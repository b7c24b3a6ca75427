// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/ScissorSet.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

// How deep scissors reach that take what is seen.

namespace limn {
namespace {

// So many depths, evenly from the first to the last.
std::vector<double> evenly(double first, double last, int count) {
  std::vector<double> depths;
  for (int n = 0; n < count; ++n)
    depths.push_back(first + (last - first) * n / (count - 1));
  return depths;
}

std::vector<double> joined(std::vector<double> depths, const std::vector<double>& others) {
  depths.insert(depths.begin(), others.begin(), others.end()); // in no order
  return depths;
}

TEST(SeenDepth, ofWhatHangsTogetherIsItsFarthestPlace) {
  EXPECT_EQ(depthOfSeen({7.0}), 7.0);
  EXPECT_EQ(depthOfSeen(evenly(300.0, 390.0, 400)), 390.0);
  std::vector<double> ball; // seen from afar: few rays meet its rim, far behind
  for (int y = -12; y <= 12; ++y)
    for (int x = -12; x <= 12; ++x)
      if (const double away = (x * x + y * y) / 144.0; away < 1.0)
        ball.push_back(500.0 - 90.0 * std::sqrt(1.0 - away));
  EXPECT_EQ(depthOfSeen(ball), std::ranges::max(ball));
}

TEST(SeenDepth, leavesWhatShowsFarBehindThroughASmallGap) {
  const std::vector<double> near = evenly(300.0, 320.0, 90);
  EXPECT_EQ(depthOfSeen(joined(near, evenly(390.0, 400.0, 10))), 320.0);
  EXPECT_EQ(depthOfSeen(joined(near, evenly(390.0, 400.0, 30))), 320.0) << "a quarter";
  EXPECT_EQ(depthOfSeen(joined(near, evenly(390.0, 400.0, 31))), 400.0) << "more than that is meant, too";
  EXPECT_EQ(depthOfSeen(joined(near, evenly(329.0, 335.0, 10))), 335.0) << "not far behind";
  EXPECT_EQ(depthOfSeen(joined(evenly(300.0, 360.0, 90), evenly(385.0, 390.0, 10))), 390.0)
      << "no farther than it is deep itself";
  // Of two gaps the nearer one.
  EXPECT_EQ(depthOfSeen(joined(near, joined(evenly(340.0, 345.0, 10), evenly(400.0, 410.0, 10)))), 320.0);
}

} // namespace
} // namespace limn
