// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/sweep/OperatingPoint.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

MeasuredPoint measured(double stepVoxels, double p99_9, double ms) {
  MeasuredPoint point;
  point.point.stepVoxels = stepVoxels;
  point.error.p99_9 = p99_9;
  point.error.mean = p99_9 / 8;
  point.ms = {ms, ms, ms};
  return point;
}

TEST(OperatingPoint, isParetoOptimalWhereNoOtherIsAsFastAndAsAccurate) {
  std::vector<MeasuredPoint> points{measured(1, 8, 10), measured(0.5, 2, 20), measured(0.25, 3, 30),
                                    measured(2, 8, 10), measured(4, 8, 12)};
  markPareto(points);
  EXPECT_TRUE(points[0].isPareto);
  EXPECT_TRUE(points[1].isPareto);
  EXPECT_FALSE(points[2].isPareto) << "slower and less accurate than the second";
  EXPECT_TRUE(points[3].isPareto) << "equal points do not beat each other";
  EXPECT_FALSE(points[4].isPareto) << "as accurate as the first, slower";
}

TEST(OperatingPoint, isChosenByAWishOrNot) {
  const std::vector<MeasuredPoint> points{measured(1, 8, 10), measured(0.5, 2, 20), measured(0.25, 0.5, 40)};
  ASSERT_TRUE(fastestWithin(points, 2.0));
  EXPECT_EQ(fastestWithin(points, 2.0)->point.stepVoxels, 0.5);
  EXPECT_EQ(fastestWithin(points, 0.1), nullptr);
  ASSERT_TRUE(mostAccurateWithin(points, 33.0));
  EXPECT_EQ(mostAccurateWithin(points, 33.0)->point.stepVoxels, 0.5);
  EXPECT_EQ(mostAccurateWithin(points, 5.0), nullptr);
}

TEST(OperatingPoint, showsItsOrderBesideThePointOfTwiceItsStep) {
  std::vector<MeasuredPoint> points{measured(1, 8, 10), measured(0.5, 2, 20), measured(0.125, 1, 80)};
  points.push_back(measured(0.25, 1, 50));
  points.back().point.preintegrated = true;
  findOrders(points);
  EXPECT_FALSE(points[0].order) << "nothing coarser";
  ASSERT_TRUE(points[1].order);
  EXPECT_DOUBLE_EQ(*points[1].order, 2.0);
  EXPECT_FALSE(points[2].order) << "1/4 is missing between 1/2 and 1/8";
  EXPECT_FALSE(points[3].order) << "another family";
}

TEST(OperatingPoint, namesItsFamilyAndStep) {
  OperatingPoint point;
  EXPECT_EQ(familyOf(point), "rays");
  EXPECT_EQ(stepOf(point), "step 1/2");
  point.stepVoxels = 2.0;
  EXPECT_EQ(stepOf(point), "step 2");
  point.toleranceLevels = 1.0;
  EXPECT_EQ(stepOf(point), "within 1 level");
  EXPECT_EQ(familyOf(point), "rays, error-controlled");
}

TEST(OperatingPoint, namesItsFamilyByEveryDecision) {
  OperatingPoint point;
  point.engine = Engine::slices;
  point.preintegrated = true;
  point.earlyTermination = 1.0;
  point.gradients = GradientSource::precomputed;
  point.imageScale = 0.5;
  EXPECT_EQ(familyOf(point),
            "slices, pre-integrated, stored gradients, never ends early, 50 % of the pixels each way");
}

} // namespace
} // namespace limn
