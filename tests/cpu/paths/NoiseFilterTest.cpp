// SPDX-License-Identifier: GPL-3.0-or-later
// The filter of the noise that paths leave (cpu/paths/NoiseFilter): it brings pictures nearer to the exact
// one, and what it says of its error is so.
#include "cpu/paths/NoiseFilter.h"
#include "cpu/CpuRenderer.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

namespace limn {
namespace {

constexpr glm::ivec2 filteredPicture{96, 84};

Scene headOfFewPaths(int paths) {
  Scene scene = headScene(phantomVolume({.spacingMm = 4.0}), ShadingModel::physical);
  scene.camera = orbited(scene.camera, 0.5, 0.3);
  scene.camera.fovYDeg *= 0.5; // as fine as pictures of twice the size are
  scene.shading.lightDirection = glm::dvec3(0.6, -0.7, 1.0);
  scene.shading.lightAxes = LightAxes::camera;
  scene.shading.physical.sky = {0.2, 0.4};
  scene.shading.physical.until = UntilPaths{paths};
  return scene;
}

double rmsLevelsBetween(const Image& one, const Image& other) {
  double squares = 0.0, count = 0.0;
  for (std::size_t n = 0; n < one.pixels.size(); ++n) {
    if (!(one.pixels[n].a >= 1.0f / 510.0f))
      continue;
    const glm::dvec3 apart = 255.0 * glm::dvec3(glm::vec3(one.pixels[n]) - glm::vec3(other.pixels[n]));
    squares += glm::dot(apart, apart);
    count += 3.0;
  }
  return std::sqrt(squares / count);
}

class NoiseFilters : public testing::Test {
protected:
  cpu::FilteredPaths filteredOf(const Scene& scene, int threads = 0) {
    CpuRenderer renderer(threads);
    noisy = renderer.render(scene, filteredPicture);
    said = *renderer.pathFigures(scene, filteredPicture);
    return *renderer.withoutNoise(scene, filteredPicture);
  }

  Image noisy;
  PathFigures said;
};

TEST_F(NoiseFilters, picturesAreNearerToTheExactOneAndTellHowNear) {
  Scene exact = headOfFewPaths(512);
  exact.shading.physical.seed = 99; // nothing in common
  const Image converged = CpuRenderer().render(exact, filteredPicture);
  for (const int paths : {8, 32}) {
    const cpu::FilteredPaths found = filteredOf(headOfFewPaths(paths));
    const double before = rmsLevelsBetween(noisy, converged);
    const double after = rmsLevelsBetween(found.image, converged);
    ASSERT_TRUE(found.rmsLevels);
    std::cout << paths << " paths: " << before << " levels RMS, filtered " << after << ", said "
              << *found.rmsLevels << ", changed by " << found.figures.rmsChange << '\n';
    EXPECT_LT(after, 0.75 * before);
    // What is said is that of half of the paths, at most about √2 of all; and the yardstick has noise of its
    // own.
    EXPECT_GT(*found.rmsLevels, 0.85 * after);
    EXPECT_LT(*found.rmsLevels, 1.6 * after);
    EXPECT_NEAR(found.figures.rmsChange, rmsLevelsBetween(found.image, noisy), 1e-3);
    EXPECT_GE(found.figures.largestChange, found.figures.rmsChange);
    for (std::size_t n = 0; n < noisy.pixels.size(); ++n)
      ASSERT_EQ(found.image.pixels[n].a, noisy.pixels[n].a);
  }
}

TEST_F(NoiseFilters, areTheSameWithAnyThreadsAndFollowNoPath) {
  const Scene scene = headOfFewPaths(8);
  const Image one = filteredOf(scene, 1).image;
  EXPECT_EQ(filteredOf(scene, 3).image, one);
  CpuRenderer renderer(2);
  const Image before = renderer.render(scene, filteredPicture);
  ASSERT_TRUE(renderer.withoutNoise(scene, filteredPicture));
  EXPECT_EQ(renderer.render(scene, filteredPicture), before);
}

TEST_F(NoiseFilters, fewerThanFourPathsStayAsTheyAre) {
  for (const int paths : {1, 2, 3}) {
    const cpu::FilteredPaths found = filteredOf(headOfFewPaths(paths));
    EXPECT_EQ(found.image, noisy) << paths;
    EXPECT_FALSE(found.rmsLevels) << paths;
    EXPECT_EQ(found.figures, NoiseFigures{}) << paths;
  }
}

TEST_F(NoiseFilters, thinTissueIsNotSaidToBeNearerThanItIs) {
  Scene thin = headOfFewPaths(6);
  thin.shading.physical.density = 0.05;
  Scene exact = thin;
  exact.shading.physical.until = UntilPaths{256};
  exact.shading.physical.seed = 99;
  const Image converged = CpuRenderer().render(exact, filteredPicture);
  const cpu::FilteredPaths found = filteredOf(thin);
  ASSERT_TRUE(found.rmsLevels);
  const double after = rmsLevelsBetween(found.image, converged);
  std::cout << "thin tissue: filtered " << after << " levels RMS, said " << *found.rmsLevels << '\n';
  EXPECT_GT(*found.rmsLevels, 0.85 * after);
}

TEST_F(NoiseFilters, canBeCancelled) {
  const Scene scene = headOfFewPaths(4);
  CpuRenderer renderer(1);
  EXPECT_FALSE(renderer.withoutNoise(scene, filteredPicture)) << "no picture of it yet";
  renderer.render(scene, filteredPicture);
  EXPECT_THROW(renderer.withoutNoise(scene, filteredPicture, {1, [] { return true; }, {}}), Cancelled);
}

} // namespace
} // namespace limn
