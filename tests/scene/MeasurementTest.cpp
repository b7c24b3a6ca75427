// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/view/Measurement.h"

#include "scene/volume/Orientation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace limn {
namespace {

using Kind = Measurement::Kind;

TEST(Measurement, aDistanceIsStraightThroughSpace) {
  EXPECT_EQ(lengthMm({Kind::distance, PatientPlane::axial, {{1, 1, 5}, {4, 5, 5}}}), 5.0) << "3, 4, 5";
  EXPECT_EQ(lengthMm({Kind::distance, std::nullopt, {{0, 0, 0}, {2, 3, 6}}}), 7.0) << "2² + 3² + 6² = 7²";
  EXPECT_EQ(lengthMm({Kind::distance, std::nullopt, {{2, 3, 6}, {2, 3, 6}}}), 0.0);
}

TEST(Measurement, anAngleIsThatOfTheDotProduct) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> place(-200.0, 200.0);
  const auto anywhere = [&] { return glm::dvec3(place(random), place(random), place(random)); };
  for (int n = 0; n < 200; ++n) {
    const Measurement angle{Kind::angle, std::nullopt, {anywhere(), anywhere(), anywhere()}};
    const glm::dvec3 a = glm::normalize(angle.placesMm[0] - angle.placesMm[1]);
    const glm::dvec3 b = glm::normalize(angle.placesMm[2] - angle.placesMm[1]);
    const double expected = std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0)) * 180.0 / std::numbers::pi;
    // An arc cosine of a number rounded to 1e-16 errs by up to its root where the legs are nearly in line.
    EXPECT_NEAR(*angleDegrees(angle), expected, 1e-6) << n;
  }
}

TEST(Measurement, flatAndSharpAnglesKeepTheirDigits) {
  // The tangent of the angle is 1e-9: an arc cosine would tell 0.
  const double small = std::atan(1e-9) * 180.0 / std::numbers::pi;
  EXPECT_NEAR(*angleDegrees({Kind::angle, std::nullopt, {{1, 0, 0}, {0, 0, 0}, {1, 1e-9, 0}}}), small,
              small * 1e-9);
  EXPECT_NEAR(180.0 - *angleDegrees({Kind::angle, std::nullopt, {{1, 0, 0}, {0, 0, 0}, {-1, 1e-9, 0}}}),
              small, 180.0 * 1e-15)
      << "rounding of 180";
  EXPECT_EQ(*angleDegrees({Kind::angle, std::nullopt, {{5, 0, 0}, {0, 0, 0}, {0, 0, 2}}}), 90.0);
}

TEST(Measurement, withoutALegThereIsNoAngle) {
  EXPECT_FALSE(angleDegrees({Kind::angle, std::nullopt, {{1, 2, 3}, {1, 2, 3}, {4, 5, 6}}}));
  EXPECT_FALSE(angleDegrees({Kind::angle, std::nullopt, {{4, 5, 6}, {1, 2, 3}, {1, 2, 3}}}));
  EXPECT_EQ(angleDegrees({Kind::angle, std::nullopt, {{4, 5, 6}, {1, 2, 3}, {4, 5, 6}}}), 0.0)
      << "both ends in one place are an angle of 0";
}

TEST(Measurement, marksTakeTheFirstNumberThatIsFree) {
  std::vector<Measurement> list;
  EXPECT_EQ(freeName(list), "1");
  list = {{Kind::mark, std::nullopt, {{0, 0, 0}}, "1"},
          {Kind::mark, std::nullopt, {{0, 0, 0}}, "3"},
          {Kind::distance, std::nullopt, {{0, 0, 0}, {1, 1, 1}}, "2"}};
  EXPECT_EQ(freeName(list), "4");
  list.erase(list.begin());
  EXPECT_EQ(freeName(list), "1");
}

// Columns ran to the left, rows to the back, slices to the head; a person says: to the head, back and left.
TEST(Measurement, staysOnItsTissueWhereTheVoxelsLieOtherwise) {
  Grid from;
  from.dims = {8, 9, 10};
  from.spacingMm = {1.0, 2.0, 3.0};
  from.originMm = {-4.0, 5.0, 6.0};
  const Grid to = withAxisLetters(from, "SPL");
  const glm::dvec3 a(1, 2, 3), b(4, 6, 3);
  const auto in = [&](const Grid& grid, PatientPlane plane) {
    return Measurement{Kind::distance, plane, {indexToWorld(grid, a), indexToWorld(grid, b)}};
  };
  const Measurement moved = measurementsMoved({in(from, PatientPlane::axial)}, from, to).front();
  EXPECT_EQ(moved.plane, PatientPlane::sagittal) << "slices lie across the left-right axis now";
  for (std::size_t end = 0; end < 2; ++end) // rounding of places of some ten millimetres
    EXPECT_LT(glm::length(moved.placesMm[end] - in(to, PatientPlane::sagittal).placesMm[end]), 1e-12);
  EXPECT_NEAR(lengthMm(moved), lengthMm(in(from, PatientPlane::axial)), 1e-12);
  const auto planeOf = [&](PatientPlane plane) {
    return *measurementsMoved({in(from, plane)}, from, to).front().plane;
  };
  EXPECT_EQ(planeOf(PatientPlane::coronal), PatientPlane::coronal);
  EXPECT_EQ(planeOf(PatientPlane::sagittal), PatientPlane::axial);
}

TEST(Measurement, isSeenFromTheMiddleOfItsPlaces) {
  EXPECT_EQ(middleMm({Kind::distance, std::nullopt, {{0, 2, 4}, {2, 4, 8}}}), glm::dvec3(1, 3, 6));
  EXPECT_EQ(middleMm({Kind::mark, std::nullopt, {{7, 8, 9}}}), glm::dvec3(7, 8, 9));
}

} // namespace
} // namespace limn
