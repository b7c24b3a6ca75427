// SPDX-License-Identifier: GPL-3.0-or-later
#include "LookText.h"

#include "io/looks/curves/CurvedSegments.h"

namespace limn {
namespace {

// The rule as VTK's documentation has it, written plainly: y between y1 and y2 at x between x1 and x2.
double vtkOpacity(double x, double x1, double y1, double x2, double y2, double midpoint, double sharpness) {
  double u = (x - x1) / (x2 - x1);
  u = u < midpoint ? 0.5 * u / midpoint : 0.5 + 0.5 * (u - midpoint) / (1.0 - midpoint);
  if (sharpness > 0.99)
    return u < 0.5 ? y1 : y2;
  if (sharpness < 0.01)
    return (1.0 - u) * y1 + u * y2;
  if (u < 0.5)
    u = 0.5 * std::pow(u * 2.0, 1.0 + 10.0 * sharpness);
  else if (u > 0.5)
    u = 1.0 - 0.5 * std::pow((1.0 - u) * 2.0, 1.0 + 10.0 * sharpness);
  const double square = u * u, cube = square * u;
  const double tangent = (1.0 - sharpness) * (y2 - y1);
  const double y = (2.0 * cube - 3.0 * square + 1.0) * y1 + (-2.0 * cube + 3.0 * square) * y2 +
                   (cube - 2.0 * square + u) * tangent + (cube - square) * tangent;
  return std::clamp(y, std::min(y1, y2), std::max(y1, y2));
}

BentPoint bent(double value, double opacity, double midpoint = 0.5, double sharpness = 0.0) {
  return {{value, glm::dvec3(1.0), opacity}, midpoint, sharpness};
}

BentPoint coloured(double value, const glm::dvec3& color) {
  return {{value, color, 0.0}};
}

TEST(CurvedSegments, theirPointsAreVtksForEveryMidpointAndSharpness) {
  for (const double midpoint : {1e-5, 0.1, 0.5, 0.8, 0.99999})
    for (const double sharpness : {0.0, 0.009, 0.02, 0.4, 0.9, 0.99}) {
      std::vector<Message> changes;
      const std::vector<ControlPoint> points =
          straightened({bent(0.0, 0.0, midpoint, sharpness), bent(1.0, 1.0)}, {}, "demo.look", changes);
      for (const ControlPoint& point : points)
        EXPECT_NEAR(point.opacity, vtkOpacity(point.value, 0.0, 0.0, 1.0, 1.0, midpoint, sharpness), 1e-9)
            << midpoint << " " << sharpness << " at " << point.value;
    }
}

TEST(CurvedSegments, stepsAreVtksForEveryMidpoint) {
  for (const double midpoint : {1e-5, 0.1, 0.5, 0.8, 0.99999})
    for (const double sharpness : {0.995, 1.0}) {
      std::vector<Message> changes;
      const TransferFunction function{
          1.0, straightened({bent(0.0, 0.0, midpoint, sharpness), bent(1.0, 1.0)}, {}, "demo.look", changes)};
      for (int i = 0; i <= 400; ++i)
        EXPECT_EQ(classify(function, i / 400.0).opacity,
                  vtkOpacity(i / 400.0, 0.0, 0.0, 1.0, 1.0, midpoint, sharpness))
            << midpoint << " " << sharpness << " at " << i;
    }
}

TEST(CurvedSegments, bentSegmentsAreFollowedWithinTheStatedError) {
  for (const double midpoint : {0.02, 0.3, 0.5, 0.9})
    for (const double sharpness : {0.05, 0.3, 0.7, 0.98}) {
      std::vector<Message> changes;
      const TransferFunction function{
          1.0,
          straightened({bent(-100.0, 0.9, midpoint, sharpness), bent(700.0, 0.0)}, {}, "demo.look", changes)};
      EXPECT_TRUE(test::isTold(changes, "differ from them by at most 0.01"));
      EXPECT_LE(function.points.size(), 20u) << "as few as it needs";
      double largest = 0.0;
      for (int i = 0; i < 20011; ++i) {
        const double value = -100.0 + 800.0 * i / 20011.0;
        largest =
            std::max(largest, std::abs(classify(function, value).opacity -
                                       vtkOpacity(value, -100.0, 0.9, 700.0, 0.0, midpoint, sharpness)));
      }
      EXPECT_LE(largest, 0.01) << midpoint << " " << sharpness;
    }
}

TEST(CurvedSegments, straightOnesAndMidpointsAloneAreExact) {
  std::vector<Message> changes;
  EXPECT_EQ(straightened({bent(0.0, 0.0), bent(10.0, 1.0)}, {}, "demo.look", changes).size(), 2u);
  const auto kinked = straightened({bent(0.0, 0.0, 0.25), bent(8.0, 1.0)}, {}, "demo.look", changes);
  ASSERT_EQ(kinked.size(), 3u);
  EXPECT_EQ(kinked[1].value, 2.0);
  EXPECT_EQ(kinked[1].opacity, 0.5);
  EXPECT_TRUE(changes.empty()) << "nothing is lost";
}

TEST(CurvedSegments, aSharpnessOverItsLimitIsATrueStep) {
  // VTK itself ramps here since 2023, by mistake.
  std::vector<Message> changes;
  const TransferFunction function{
      1.0, straightened({bent(0.0, 0.1, 0.5, 1.0), bent(100.0, 0.7)}, {}, "demo.look", changes)};
  EXPECT_EQ(classify(function, 49.999).opacity, 0.1);
  EXPECT_EQ(classify(function, 50.0).opacity, 0.7);
  EXPECT_TRUE(test::isTold(changes, "VTK since 2023")) << "it looks otherwise there";
  changes.clear();
  std::vector<BentPoint> colors{coloured(0.0, {1, 0, 0}), coloured(10.0, {0, 1, 0})};
  colors.front().sharpness = 1.0;
  EXPECT_EQ(straightened(colors, {}, "demo.look", changes).size(), 4u);
  EXPECT_TRUE(changes.empty()) << "colours still step there";
}

TEST(CurvedSegments, aLogarithmicScaleIsFollowedInLog10) {
  std::vector<Message> changes;
  const TransferFunction function{
      1.0, straightened({bent(0.1, 0.0), bent(1000.0, 1.0)}, {ColorSpace::rgb, true}, "demo.look", changes)};
  double largest = 0.0;
  for (int i = 0; i <= 20000; ++i) {
    const double value = std::pow(10.0, -1.0 + 4.0 * i / 20000.0);
    largest =
        std::max(largest, std::abs(classify(function, value).opacity - (std::log10(value) + 1.0) / 4.0));
  }
  EXPECT_LE(largest, 0.01);
  EXPECT_THROW(straightened({bent(0.0, 0.0), bent(1.0, 1.0)}, {ColorSpace::rgb, true}, "demo.look", changes),
               Error);
}

TEST(CurvedSegments, hueSaturationAndValueAreFollowed) {
  // From red (0°) to blue (240°): through green where the hue may not wrap, through magenta where it may.
  std::vector<Message> changes;
  const std::vector<BentPoint> points{coloured(0.0, {1, 0, 0}), coloured(1.0, {0, 0, 1})};
  const TransferFunction plain{1.0, straightened(points, {ColorSpace::hsv}, "demo.look", changes)};
  const TransferFunction wrapped{1.0, straightened(points, {ColorSpace::wrappedHsv}, "demo.look", changes)};
  EXPECT_LE(test::difference(classify(plain, 0.5), {{0.0, 1.0, 0.0}, 0.0}), 0.01) << "120° is green";
  EXPECT_LE(test::difference(classify(plain, 0.25), {{1.0, 1.0, 0.0}, 0.0}), 0.01) << "60° is yellow";
  EXPECT_LE(test::difference(classify(wrapped, 0.5), {{1.0, 0.0, 1.0}, 0.0}), 0.01) << "300° is magenta";
  double largest = 0.0;
  for (int i = 0; i <= 5000; ++i)
    largest =
        std::max(largest, test::difference(classify(plain, i / 5000.0),
                                           {mixed(ColorSpace::hsv, {1, 0, 0}, {0, 0, 1}, i / 5000.0), 0.0}));
  EXPECT_LE(largest, 0.01);
}

TEST(CurvedSegments, labIsStraightInLightness) {
  // L* of sRGB grey 119/255 is 50.03 (CIE 15 with IEC 61966-2-1): half way from black to white.
  EXPECT_LE(glm::length(mixed(ColorSpace::lab, glm::dvec3(0.0), glm::dvec3(1.0), 0.5) - glm::dvec3(0.4663)),
            2e-3);
  const glm::dvec3 from{0.8, 0.2, 0.1}, to{0.1, 0.4, 0.9};
  EXPECT_LE(glm::length(mixed(ColorSpace::lab, from, to, 0.0) - from), 1e-6);
  EXPECT_LE(glm::length(mixed(ColorSpace::lab, from, to, 1.0) - to), 1e-6);
}

TEST(CurvedSegments, divergingPassesThroughWhite) {
  // Moreland's cool to warm: its middle is the grey of M = 88, which is 0.865 of white in each channel.
  const glm::dvec3 cool{0.230, 0.299, 0.754}, warm{0.706, 0.016, 0.150};
  EXPECT_LE(glm::length(mixed(ColorSpace::diverging, cool, warm, 0.5) - glm::dvec3(0.865)), 2e-3);
  EXPECT_LE(glm::length(mixed(ColorSpace::diverging, cool, warm, 0.0) - cool), 1e-6);
  EXPECT_LE(glm::length(mixed(ColorSpace::diverging, cool, warm, 1.0) - warm), 1e-6);
  // A quarter of the way, from his table of 33 colours.
  EXPECT_LE(glm::length(mixed(ColorSpace::diverging, cool, warm, 0.25) - glm::dvec3(0.553, 0.690, 0.996)),
            0.01);
}

TEST(CurvedSegments, aStepTakesTheColourOnItsRight) {
  std::vector<Message> changes;
  const std::vector<BentPoint> points{coloured(0.0, {1, 0, 0}), coloured(10.0, {0, 1, 0}),
                                      coloured(20.0, {0, 0, 1})};
  const TransferFunction function{1.0, straightened(points, {ColorSpace::step}, "demo.look", changes)};
  EXPECT_EQ(classify(function, -1.0).color, glm::dvec3(1, 0, 0));
  EXPECT_EQ(classify(function, 5.0).color, glm::dvec3(0, 1, 0));
  EXPECT_EQ(classify(function, 15.0).color, glm::dvec3(0, 0, 1));
  EXPECT_EQ(classify(function, 25.0).color, glm::dvec3(0, 0, 1));
}

} // namespace
} // namespace limn
