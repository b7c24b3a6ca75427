// SPDX-License-Identifier: GPL-3.0-or-later
// Scalars and surfaces found cell by cell: closed forms, and what ever finer samples come to.
#include "reference/ReferenceIntegrator.h"
#include "scene/ProjectionFacts.h"
#include "scene/volume/Volume.h"
#include "stability/scenes/SimpleScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace limn {
namespace {

constexpr glm::ivec2 noisePicture(40, 32);

Scene exact(Scene scene) {
  scene.quality.toleranceLevels = 1.0;
  return scene;
}

// A column whose alpha is its scalar, seen from the end.
double alphaOf(const std::vector<double>& scalars, Projection projection) {
  Scene scene = rayThrough(columnOf(scalars, 1.0));
  scene.transferFunction = {1.0, {{0.0, white, 0.0}, {1.0, white, 1.0}}};
  scene.projection = projection;
  return renderReference(exact(scene), {1, 1}, 1).pixels[0].a;
}

TEST(CellScalars, aColumnIsLinearBetweenItsVoxelsAndFlatAtItsEnds) {
  const std::vector<double> column{0.25, 0.75, 0.125, 0.5};
  EXPECT_NEAR(alphaOf(column, Projection::mip), 0.75, 1e-14);
  EXPECT_NEAR(alphaOf(column, Projection::minip), 0.125, 1e-14);
  // Half a voxel at each end, and trapezia between.
  const double mean = (0.5 * 0.25 + 0.5 + 0.4375 + 0.3125 + 0.5 * 0.5) / 4.0;
  EXPECT_NEAR(alphaOf(column, Projection::average), mean, 1e-14);
}

// Voxels drawn at random: fields with turns in nearly every cell. Alpha is the scalar.
Scene noise(Projection projection, bool isPart) {
  Grid grid;
  grid.dims = {7, 6, 5};
  grid.spacingMm = {1.0, 1.25, 1.5};
  std::mt19937 random(11);
  std::vector<std::uint8_t> voxels(7 * 6 * 5);
  for (std::uint8_t& voxel : voxels)
    voxel = static_cast<std::uint8_t>(random() % 256);
  Scene scene;
  scene.volume =
      std::make_shared<const Volume>(grid, voxels, Rescale{1.0 / 255.0, 0.0}, std::nullopt, VolumeInfo{});
  scene.transferFunction = {1.0, {{0.0, white, 0.0}, {1.0, white, 1.0}}};
  scene.projection = projection;
  scene.isovalue = 0.6;
  scene.camera = orbited(defaultCamera(grid), 0.5, 0.3);
  scene.quality.stepVoxels = 1.0 / 512.0;
  if (isPart)
    scene.keep = cubesRegion(grid.dims, 2, {1.0, 0.0, 0.7});
  return scene;
}

// One scalar unit per voxel along each axis is the steepest that noise can be.
constexpr double steepestPerStep = 1.7321 / 512.0;

TEST(CellScalars, noSampleLiesBeyondThemAndTheFinestComeNear) {
  for (const bool isPart : {false, true})
    for (const Projection projection : {Projection::mip, Projection::minip}) {
      const Scene scene = noise(projection, isPart);
      const ReferencePicture sampled = renderReference(scene, noisePicture);
      const ReferencePicture found = renderReference(exact(scene), noisePicture);
      const double sign = projection == Projection::mip ? 1.0 : -1.0;
      double mostApart = 0.0;
      for (std::size_t i = 0; i < found.pixels.size(); ++i) {
        // A ray may keep too little for any sample.
        if (sampled.pixels[i] == glm::dvec4(0.0))
          continue;
        const double beyond = sign * (found.pixels[i].a - sampled.pixels[i].a);
        EXPECT_GE(beyond, -1e-12) << "pixel " << i;
        mostApart = std::max(mostApart, beyond);
      }
      EXPECT_LE(mostApart, steepestPerStep) << "a step at most lies between it and a sample";
      EXPECT_GT(mostApart, 0.0);
    }
}

TEST(CellScalars, theMeanIsWhatFinerSamplesComeTo) {
  for (const bool isPart : {false, true}) {
    Scene scene = noise(Projection::average, isPart);
    const ReferencePicture found = renderReference(exact(scene), noisePicture);
    const auto largestOff = [&](double stepVoxels) {
      scene.quality.stepVoxels = stepVoxels;
      const ReferencePicture sampled = renderReference(scene, noisePicture);
      std::vector<double> off;
      for (std::size_t i = 0; i < found.pixels.size(); ++i)
        off.push_back(std::abs(found.pixels[i].a - sampled.pixels[i].a));
      std::sort(off.begin(), off.end());
      return off[off.size() * 95 / 100]; // rays that keep next to nothing have next to no sample
    };
    const double coarse = largestOff(1.0 / 32.0), fine = largestOff(1.0 / 512.0);
    EXPECT_GT(coarse, 0.0);
    EXPECT_LE(fine, coarse / (isPart ? 8.0 : 64.0)) << "where a region ends samples are of first order";
  }
}

TEST(CellScalars, aSurfaceLiesWhereFineSamplesFindIt) {
  for (const bool isPart : {false, true}) {
    Scene scene = noise(Projection::isosurface, isPart);
    scene.shading.ambient = 1.0;
    scene.shading.diffuse = scene.shading.specular = 0.0;
    // Brightness tells the depth: 1 in 40 mm.
    scene.fog.mode = Fog::Mode::linear;
    scene.fog.color = glm::dvec3(0.0);
    scene.fog.startMm = 0.0;
    scene.fog.endMm = 40.0;
    const ReferencePicture sampled = renderReference(scene, noisePicture);
    const ReferencePicture found = renderReference(exact(scene), noisePicture);
    int hits = 0, grazes = 0;
    for (std::size_t i = 0; i < found.pixels.size(); ++i) {
      // Depths of floats' bisection: a ten-thousandth of a step.
      const double apart = sampled.pixels[i].r - found.pixels[i].r;
      hits += found.pixels[i].a > 0.0 ? 1 : 0;
      // What samples step over is met later or never, so nothing is met later than by samples.
      EXPECT_LE(apart, 1e-6) << "pixel " << i;
      grazes += std::abs(apart) > 1e-6 ? 1 : 0;
    }
    EXPECT_GT(hits, 200);
    EXPECT_LE(grazes, hits / 50) << "a ray that only grazes a surface, or the edge of a region";
  }
}

} // namespace
} // namespace limn
