// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Phantom.h"
#include "scene/light/Gradient.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// How much of a part is at a point, 0..1, and its derivative: the depth below the surface along the shortest
// radius fades the part in by a smooth step.
double coverageOf(const PhantomPart& part, const glm::dvec3& p, glm::dvec3& gradient) {
  const glm::dvec3 q = (p - part.centreMm) / part.radiiMm;
  const double radius = glm::length(q);
  const double shortest = std::min({part.radiiMm.x, part.radiiMm.y, part.radiiMm.z});
  const double t = std::clamp((1.0 - radius) * shortest / part.edgeMm + 0.5, 0.0, 1.0);
  gradient = glm::dvec3(0.0);
  if (t > 0.0 && t < 1.0)
    gradient = -6.0 * t * (1.0 - t) * shortest / part.edgeMm * q / part.radiiMm / radius;
  return t * t * (3.0 - 2.0 * t);
}

// The gradient in closed form, HU/mm.
glm::dvec3 phantomGradient(const glm::dvec3& worldMm) {
  double value = -1000.0; // air
  glm::dvec3 gradient(0.0);
  for (const PhantomPart& part : phantomParts()) {
    glm::dvec3 ofCoverage;
    const double amount = coverageOf(part, worldMm, ofCoverage);
    gradient = (1.0 - amount) * gradient + ofCoverage * (part.hu - value);
    value += amount * (part.hu - value);
  }
  return gradient;
}

TEST(Phantom, gradientIsTheDerivativeOfTheValue) {
  // The edges are smooth steps, whose second derivative jumps by up to 6 · 9000 HU / (1 mm)² at their ends
  // (metal); there a central difference of half width h errs by h/4 of the jump: 0.14 HU/mm at h = 1e-5 mm.
  const double h = 1e-5;
  int edges = 0;
  for (double x = -80; x <= 80; x += 7.3)
    for (double y = -100; y <= 95; y += 6.1)
      for (double z = -120; z <= 105; z += 8.7) {
        const glm::dvec3 p(x, y, z);
        const glm::dvec3 exact = phantomGradient(p);
        for (int axis = 0; axis < 3; ++axis) {
          glm::dvec3 step(0.0);
          step[axis] = h;
          EXPECT_NEAR((phantomValue(p + step) - phantomValue(p - step)) / (2.0 * h), exact[axis], 0.14);
        }
        edges += glm::length(exact) > 1.0;
      }
  EXPECT_GT(edges, 100);
}

TEST(Phantom, holdsTheTissuesItPromises) {
  EXPECT_EQ(phantomValue({0, 0, 130}), -1000.0);            // air above the head
  EXPECT_NEAR(phantomValue({0, 0, 18 + 70.0}), 38.0, 1e-9); // cortex
  EXPECT_NEAR(phantomValue({10, -14, 30}), 8.0, 1e-9);      // ventricle
  EXPECT_NEAR(phantomValue({0, 0, 18 + 79.5}), 450.0, 1.0); // diploë
  EXPECT_NEAR(phantomValue({31, -66, -8}), 12.0, 1e-9);     // eye
}

TEST(Phantom, samplesItsFormulaAtVoxelCentres) {
  const auto volume = phantomVolume({.spacingMm = 8.0});
  const glm::ivec3 dims = volume->grid().dims;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i) {
        const glm::ivec3 index(i, j, k);
        const double exact = phantomValue(indexToWorld(volume->grid(), index));
        ASSERT_EQ(volume->value(index), std::lround(exact)) << "whole HU";
      }
  EXPECT_EQ(volume->info().unit, "HU");
}

TEST(Phantom, noiseHasTheSpreadAskedForAndRepeats) {
  const auto clean = phantomVolume({.spacingMm = 4.0});
  const auto noisy = phantomVolume({.spacingMm = 4.0, .noiseHu = 10.0, .seed = 7});
  const auto again = phantomVolume({.spacingMm = 4.0, .noiseHu = 10.0, .seed = 7});
  EXPECT_EQ(noisy->stored(), again->stored());
  double sum = 0.0;
  double squares = 0.0;
  int count = 0;
  const glm::ivec3 dims = clean->grid().dims;
  for (int k = 20; k < 40; ++k)
    for (int j = 20; j < 40; ++j)
      for (int i = 10; i < dims.x - 10; ++i, ++count) {
        const double difference = noisy->value({i, j, k}) - clean->value({i, j, k});
        sum += difference;
        squares += difference * difference;
      }
  // 11,200 samples: the mean's standard error is 10/√11200 ≈ 0.1, the deviation's 0.07.
  EXPECT_NEAR(sum / count, 0.0, 0.5);
  EXPECT_NEAR(std::sqrt(squares / count), 10.0, 0.4);
}

} // namespace
} // namespace limn
