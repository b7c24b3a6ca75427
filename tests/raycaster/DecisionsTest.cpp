// SPDX-License-Identifier: GPL-3.0-or-later
// Each decision about accuracy, taken otherwise, against a closed form: what it costs is what theory says.
#include "glsl/decisions/Decisions.h"
#include "raycaster/RayCaster.h"
#include "support/AnalyticCases.h"
#include "support/AnalyticScenes.h"
#include "support/ConvergingScenes.h"
#include "support/GlTest.h"
#include "support/Orders.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>

namespace limn {
namespace {

using DecisionPixels = test::GlTest;

// What rounding in float costs one pixel (the cases' own tolerance).
constexpr double rounding = 2e-6;

RayCaster pixelCaster(const Decisions& decisions) {
  return RayCaster(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, decisions);
}

glm::dvec4 pixelOf(const Scene& scene, const Decisions& decisions) {
  return glm::dvec4(pixelCaster(decisions).render(scene, {1, 1}).pixels[0]);
}

// Two voxels of 0 and 1 side by side: a ray between them sees 1/2 on its way of 1 mm, the unit distance.
Scene betweenTwoVoxels(const TransferFunction& function) {
  Grid grid;
  grid.dims = {2, 1, 1};
  grid.originMm.x = -0.5;
  Scene scene = test::rayThrough(std::make_shared<const Volume>(grid, std::vector<float>{0.0f, 1.0f},
                                                                Rescale{}, std::nullopt, VolumeInfo{}));
  scene.transferFunction = function;
  return scene;
}

// H27, closed form A5: between an entry of opacity 0 and one of opacity 1 lies 1/2, which over a tenth of the
// unit distance is 1 - (1/2)^(1/10) = 0.067. Corrected first, the entries are 0 and 1 - (2^-24)^(1/10) =
// 0.811, because opacity is limited to 1 - 2^-24, and half of that lies between: six times too much. (The
// case has no such limit and comes to 0.5.)
TEST_F(DecisionPixels, anOpacityCorrectedInTheTableIsFarTooHighBetweenItsEntries) {
  Scene scene =
      betweenTwoVoxels({1.0, {{127.0 / 255.0, glm::dvec3(1.0), 0.0}, {128.0 / 255.0, glm::dvec3(1.0), 1.0}}});
  scene.crop.lower.y = 0.45;
  scene.crop.upper.y = 0.55;
  scene.quality.stepVoxels = 0.1;
  const double exact = 1.0 - std::pow(0.5, 0.1);
  EXPECT_NEAR(exact, 0.0669670084631925840, 1e-15);
  for (const TableFormat format : {TableFormat::exact, TableFormat::floats256})
    EXPECT_NEAR(pixelOf(scene, {.table = format}).a, exact, rounding);
  EXPECT_NEAR(pixelOf(scene, {.table = TableFormat::correctedFloats}).a, 0.5 * (1.0 - std::exp2(-2.4)),
              rounding);
}

// H27, closed form K2: an opacity of 0.001 is 0 in 8 bits, and 1/255 the least that is not.
TEST_F(DecisionPixels, aTableOfBytesLosesWhatIsFaintAndDeep) {
  Scene scene = test::rayThrough(test::boxOf(glm::dvec3(1000.0)));
  scene.transferFunction = test::constantFunction(0.001, glm::dvec3(1.0));
  const double exact = 1.0 - std::pow(0.999, 1000.0);
  EXPECT_NEAR(exact, 0.632304575229036, 1e-12);
  EXPECT_NEAR(pixelOf(scene, {}).a, exact, rounding);
  EXPECT_NEAR(pixelOf(scene, {.table = TableFormat::floats256}).a, exact, rounding);
  EXPECT_EQ(pixelOf(scene, {.table = TableFormat::bytes256}).a, 0.0);
  scene.transferFunction = test::constantFunction(1.0 / 255.0, glm::dvec3(1.0));
  EXPECT_NEAR(pixelOf(scene, {.table = TableFormat::bytes256}).a, 1.0 - std::pow(254.0 / 255.0, 1000.0),
              rounding);
}

// A spike half an entry wide lies between two of 256 entries and between two of 1024 as well.
TEST_F(DecisionPixels, aTableSeesNothingBetweenItsEntries) {
  const double middle = 127.5 / 255.0, half = 0.2 / 1023.0;
  const Scene scene = betweenTwoVoxels(
      {1.0, {{middle - half, white, 0.0}, {middle, white, 0.6}, {middle + half, white, 0.0}}});
  EXPECT_NEAR(pixelOf(scene, {}).a, 0.6, rounding);
  for (const TableFormat format : {TableFormat::floats1024, TableFormat::floats256, TableFormat::bytes256})
    EXPECT_EQ(pixelOf(scene, {.table = format}).a, 0.0);
}

// Classified before interpolation, both voxels are transparent and so is what lies between them, where the
// scalar runs through an opaque band; and between a red and a blue voxel lies purple, where the function
// has green.
TEST_F(DecisionPixels, voxelsClassifiedBeforeInterpolationMissWhatLiesBetweenThem) {
  const glm::dvec3 red(1.0, 0.0, 0.0), green(0.0, 1.0, 0.0), blue(0.0, 0.0, 1.0);
  const Scene band = betweenTwoVoxels({1.0, {{0.0, green, 0.0}, {0.5, green, 0.5}, {1.0, green, 0.0}}});
  const Scene colors = betweenTwoVoxels({1.0, {{0.0, red, 0.5}, {0.5, green, 0.5}, {1.0, blue, 0.5}}});
  EXPECT_NEAR(pixelOf(band, {}).a, 0.5, rounding);
  EXPECT_NEAR(glm::distance(pixelOf(colors, {}), glm::dvec4(0.0, 0.5, 0.0, 0.5)), 0.0, rounding);
  for (const auto& [order, tolerance] : {std::pair{ClassificationOrder::beforeInHalves, rounding},
                                         {ClassificationOrder::beforeInBytes, 1.0 / 255.0}}) {
    EXPECT_EQ(pixelOf(band, {.classification = order}).a, 0.0);
    const glm::dvec4 between = pixelOf(colors, {.classification = order});
    for (int channel = 0; channel < 4; ++channel)
      EXPECT_NEAR(between[channel], glm::dvec4(0.25, 0.0, 0.25, 0.5)[channel], tolerance);
  }
}

// On the ramps of closed form B1: the middle of a step is of order 2, its front of order 1 (bands of
// HARD_CASES section 6).
TEST_F(DecisionPixels, samplesAtTheFrontOfTheirStepsAreOfOrderOne) {
  constexpr double floor = 20.0 * 1e-6; // where rounding hides the order
  RayCaster middle;
  RayCaster front = pixelCaster({.place = SamplePlace::front});
  int rays = 0;
  for (const nlohmann::json& one : test::analyticCases()) {
    // Behind an extinction of 40 s nothing shines out, nor does anything at its begin: where the integrand
    // vanishes at both ends, samples at any place are of order 2.
    if (one["id"].get<std::string>().rfind("B1_", 0) != 0 || one["parameters"]["k"].get<double>() > 10.0)
      continue;
    for (const test::ConvergingRay& ray : test::convergingRays(one)) {
      std::vector<double> inMiddle, atFront;
      for (const int samples : {64, 128, 256, 512}) {
        const Scene scene = test::withSamples(ray, samples);
        inMiddle.push_back(test::largestError(ray, glm::dvec4(middle.render(scene, {1, 1}).pixels[0])));
        atFront.push_back(test::largestError(ray, glm::dvec4(front.render(scene, {1, 1}).pixels[0])));
      }
      const std::vector<double> orders = test::observedOrders(atFront, floor);
      ASSERT_GE(orders.size(), 2u) << ray.what;
      for (const double order : orders) {
        EXPECT_GE(order, 0.85) << ray.what;
        EXPECT_LE(order, 1.15) << ray.what;
      }
      EXPECT_GT(atFront.back(), 20.0 * inMiddle.back()) << ray.what;
      ++rays;
    }
  }
  EXPECT_GT(rays, 0);
}

// A pixel's colour is the scalar at its place between two voxels of 0 and 1 (H30).
std::vector<float> interpolated(VolumeFormat format, int pixels) {
  Scene scene = betweenTwoVoxels({1.0, {{0.0, glm::dvec3(0.0), 1.0}, {1.0, glm::dvec3(1.0), 1.0}}});
  scene.projection = Projection::mip;
  // The camera sees from -1/2 to 1/2, from one voxel's centre to the other's.
  scene.camera.heightMm = 1.0 / pixels;
  std::vector<float> row;
  for (const glm::vec4& pixel : pixelCaster({.volume = format}).render(scene, {pixels, 1}).pixels)
    row.push_back(pixel.r);
  return row;
}

TEST_F(DecisionPixels, onlyBytesCoarsenWhatLiesBetweenVoxels) {
  constexpr int pixels = 4000;
  // An 8-bit filter may be off by a whole level; a filter in floats has only the voxels' rounding, none here.
  for (const auto& [format, tolerance] : {std::pair{VolumeFormat::r32f, rounding},
                                          {VolumeFormat::r16, 1.0 / 65535.0 + rounding},
                                          {VolumeFormat::r8, 1.0 / 255.0}}) {
    const std::vector<float> row = interpolated(format, pixels);
    double largest = 0.0;
    for (int x = 0; x < pixels; ++x)
      largest = std::max(largest, std::abs(row[static_cast<std::size_t>(x)] - (x + 0.5) / pixels));
    EXPECT_LE(largest, tolerance);
    const std::set<float> values(row.begin(), row.end());
    std::cout << values.size() << " values of " << pixels << ", error up to " << largest << "\n";
    if (rendererName().find("llvmpipe") == std::string::npos)
      continue;
    EXPECT_LE(values.size(), format == VolumeFormat::r8 ? 256u : static_cast<std::size_t>(pixels));
    EXPECT_GE(values.size(), format == VolumeFormat::r8 ? 200u : static_cast<std::size_t>(pixels) - 40);
  }
}

constexpr int squareCount = 9;

// The alphas of a row of pixels through scalars i² along an axis, i from 0 on. The curve of opacity over the
// gradient rises to 1 at 16, and the ray's way is the unit distance, so alpha is gradient/16.
std::vector<double> gradientsAlong(int axis, GradientFormat format) {
  Grid grid;
  grid.dims = glm::ivec3(1);
  grid.dims[axis] = squareCount;
  std::vector<float> squares;
  for (int i = 0; i < squareCount; ++i)
    squares.push_back(static_cast<float>(i * i));
  // A picture's rows run along x and y under these cameras, its columns downwards along z.
  const glm::dvec3 direction = axis == 1 ? glm::dvec3(-1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  Scene scene = test::rayThrough(
      std::make_shared<const Volume>(grid, squares, Rescale{}, std::nullopt, VolumeInfo{}), direction);
  scene.camera.heightMm = axis == 2 ? squareCount : 1.0;
  scene.transferFunction = test::constantFunction(1.0, glm::dvec3(1.0));
  scene.gradientOpacity = GradientOpacity{{{0.0, 0.0}, {16.0, 1.0}}};
  const glm::ivec2 size = axis == 2 ? glm::ivec2(1, squareCount) : glm::ivec2(squareCount, 1);
  std::vector<double> alphas;
  for (const glm::vec4& pixel : pixelCaster({.gradients = format}).render(scene, size).pixels)
    alphas.push_back(pixel.a);
  if (axis == 2)
    std::reverse(alphas.begin(), alphas.end());
  return alphas;
}

// At voxel i the central difference is 2i a voxel, the forward one 2i + 1; at the first and the last voxel
// differences are one-sided, 1 and 15. Of the latter, the largest, modulus bytes hold parts.
TEST_F(DecisionPixels, gradientFormatsShowTheDifferencesTheyAreMadeOf) {
  constexpr double largest = 15.0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> onTheFly = gradientsAlong(axis, GradientFormat::onTheFly);
    const std::vector<double> forward = gradientsAlong(axis, GradientFormat::forward);
    const std::vector<double> halves = gradientsAlong(axis, GradientFormat::halves);
    const std::vector<double> directions = gradientsAlong(axis, GradientFormat::directions);
    for (std::size_t i = 0; i < squareCount; ++i) {
      SCOPED_TRACE("axis " + std::to_string(axis) + ", voxel " + std::to_string(i));
      const double index = static_cast<double>(i);
      const bool isLast = i + 1 == squareCount;
      const double central = i == 0 ? 1.0 : isLast ? largest : 2.0 * index;
      EXPECT_NEAR(onTheFly[i], central / 16.0, rounding);
      EXPECT_NEAR(forward[i], (isLast ? largest : 2.0 * index + 1.0) / 16.0, rounding);
      // Halves have eleven binary digits.
      EXPECT_NEAR(halves[i], central / 16.0, central / 16.0 * 0x1p-11 + rounding);
      // Half a step of storing and as much of an 8-bit filter.
      EXPECT_NEAR(directions[i], central / 16.0, largest / 16.0 / 255.0 + rounding);
    }
  }
}

} // namespace
} // namespace limn
