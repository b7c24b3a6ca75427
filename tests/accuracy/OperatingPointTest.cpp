// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/sweep/OperatingPoint.h"
#include "accuracy/sweep/AccuracySweep.h"
#include "accuracy/sweep/FigureText.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

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

TEST(OperatingPoint, thatWasAskedForStandsAmongThoseOfItsFamily) {
  const auto toleranceOf = [](double levels) {
    OperatingPoint point;
    point.toleranceLevels = levels;
    return point;
  };
  const auto placeIn = [](const std::vector<OperatingPoint>& points, const OperatingPoint& point) {
    return std::ranges::find(points, point) - points.begin();
  };
  const std::vector<OperatingPoint> usual = usualPoints();
  for (const double levels : {16.0, 3.0, 0.1}) {
    const std::vector<OperatingPoint> points = withPoint(usual, toleranceOf(levels));
    ASSERT_EQ(points.size(), usual.size() + 1);
    std::vector<double> tolerances;
    for (const OperatingPoint& point : points)
      if (point.toleranceLevels)
        tolerances.push_back(*point.toleranceLevels);
    EXPECT_EQ(tolerances.size(), 6u);
    EXPECT_TRUE(std::ranges::is_sorted(tolerances, std::greater<>())) << levels;
  }
  EXPECT_EQ(withPoint(usual, toleranceOf(2.0)), usual) << "it is measured anyway";
  OperatingPoint step;
  step.stepVoxels = 0.3;
  const std::vector<OperatingPoint> points = withPoint(usual, step);
  EXPECT_EQ(points.at(static_cast<std::size_t>(placeIn(points, step)) - 1).stepVoxels, 0.5);
  EXPECT_EQ(points.at(static_cast<std::size_t>(placeIn(points, step)) + 1).stepVoxels, 0.25);
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

MeasuredPoint ofPaths(int paths, double rms, double ms) {
  MeasuredPoint point;
  point.point.paths = paths;
  point.error.rms = rms;
  point.error.mean = 0.8 * rms;
  point.error.p99_9 = 5.0 * rms;
  point.ms = {ms, ms, ms};
  return point;
}

TEST(OperatingPoint, ofPathsHasALawOfItsOwn) {
  std::vector<MeasuredPoint> points{ofPaths(4, 16.0, 100.0), ofPaths(8, 11.3, 200.0),
                                    ofPaths(64, 4.0, 1600.0)};
  findOrders(points);
  ASSERT_TRUE(points[1].order);
  EXPECT_NEAR(*points[1].order, 0.5, 0.005);
  EXPECT_FALSE(points[2].order) << "16 and 32 are missing";
  EXPECT_EQ(
      lawOfPaths(points).english(),
      "From 4 to 64 paths a pixel the error (RMS) falls as their number to the power of −0.5; the law of "
      "chance is −0.5. A quarter of it, 1 instead of 4 levels, takes 16 times as many paths and as long: "
      "1024 paths, 26 s.");
  EXPECT_TRUE(lawOfPaths({points[0]}).empty());
  EXPECT_TRUE(lawOfPaths({measured(1, 8, 10), measured(0.5, 2, 20)}).empty());
  // 20 levels (99.9th percentile) at 64 paths: 5 take 16 times as many, and four times the time halves them.
  const auto within = pathsWithinLevels(points, 5.0);
  ASSERT_TRUE(within);
  EXPECT_DOUBLE_EQ(within->paths, 1024.0);
  EXPECT_DOUBLE_EQ(within->ms, 25600.0);
  const auto inTime = pathsWithinMs(points, 6400.0);
  ASSERT_TRUE(inTime);
  EXPECT_DOUBLE_EQ(inTime->levels, 10.0);
  EXPECT_EQ(
      wishWithinLevels(points, 5.0),
      "By the law of 1/√n 1024 paths a pixel take 25.6 s and lie within 5.00 levels (99.9th percentile of "
      "the standard error).");
  EXPECT_FALSE(pathsWithinLevels({measured(1, 8, 10)}, 1.0));
  EXPECT_EQ(familyOf(points[0].point), "random paths");
  EXPECT_EQ(stepOf(points[0].point), "4 paths");
  EXPECT_EQ(atPoint({}, points[0].point).quality.paths, 4);
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
