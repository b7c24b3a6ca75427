// SPDX-License-Identifier: GPL-3.0-or-later
// The fast sampler of the reference against the slow functions that define field and gradient, and the order
// of the discretisation.
#include "reference/RaySamples.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/basics/Error.h"
#include "scene/light/Gradient.h"
#include "scene/volume/Phantom.h"
#include "support/AnalyticScenes.h"

#include <gtest/gtest.h>

#include <random>

namespace limn {
namespace {

Volume randomVolume(const glm::ivec3& dims) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = {0.5, 1.25, 3.0};
  std::mt19937 generator(7);
  std::vector<std::int16_t> voxels(static_cast<std::size_t>(dims.x) * dims.y * dims.z);
  for (std::int16_t& voxel : voxels)
    voxel = static_cast<std::int16_t>(generator() % 4000);
  return Volume(grid, voxels, {-0.5, 30.0}, std::nullopt, VolumeInfo{});
}

TEST(FieldSampler, scalarsAndGradientsAreThoseOfTheDefinition) {
  for (const glm::ivec3& dims : {glm::ivec3(6, 5, 4), glm::ivec3(1, 5, 4), glm::ivec3(6, 1, 1), glm::ivec3(1),
                                 glm::ivec3(2, 2, 2), glm::ivec3(3, 1, 2)}) {
    const Volume volume = randomVolume(dims);
    const FieldSampler<std::int16_t> field(volume, std::get<StoredVoxels<std::int16_t>>(volume.stored()));
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> place(-0.7, 1.2);
    for (int i = 0; i < 300; ++i) {
      // Beyond the outermost centres as well as on and between voxels.
      glm::dvec3 index = glm::dvec3(dims) * glm::dvec3(place(generator), place(generator), place(generator));
      if (i % 3 == 0)
        index = glm::round(index);
      const Cell cell = field.cellAt(index);
      EXPECT_NEAR(field.scalarAt(cell), valueAt(volume, index), 1e-9);
      EXPECT_LT(glm::distance(field.gradientAt(cell), gradientAt(volume, index)), 1e-9);
    }
  }
}

Scene smallPhantom() {
  Scene scene;
  scene.volume = phantomVolume({.spacingMm = 8.0});
  scene.camera = defaultCamera(scene.volume->grid());
  scene.transferFunction = {1.0, {{-300, glm::dvec3(1.0), 0.0}, {300, glm::dvec3(1.0), 0.3}}};
  return scene;
}

TEST(ReferenceIntegrator, anyNumberOfThreadsGivesTheSamePicture) {
  const Scene scene = smallPhantom();
  const ReferencePicture one = renderReference(scene, {40, 30}, 1);
  for (const int threads : {2, 3, 16}) {
    const ReferencePicture many = renderReference(scene, {40, 30}, threads);
    EXPECT_EQ(many.pixels, one.pixels);
    EXPECT_EQ(many.samples, one.samples);
  }
}

TEST(ReferenceIntegrator, stopsWhenItsCallerAsks) {
  int questions = 0;
  EXPECT_THROW(renderReference(smallPhantom(), {40, 30}, 1, [&questions] { return ++questions > 3; }),
               Cancelled);
}

TEST(ReferenceIntegrator, aSceneWithoutAVolumeIsRefused) {
  EXPECT_THROW(renderReference(Scene{}, {4, 4}), Error);
}

TEST(ReferenceIntegrator, halvingTheStepQuartersTheErrorWhereTheFieldIsSmooth) {
  // Case B1, k = 8, colour equal to the scalar: ∫ 8t² e^(-4t²) dt = -e^-4 + √(π/16) erf 2.
  const double exact = -std::exp(-4.0) + std::sqrt(3.14159265358979323846 / 16.0) * std::erf(2.0);
  const double unit = 1e-9;
  Scene scene = test::rayThrough(test::columnOf({0.0, 1.0}, 1.0));
  scene.crop.lower.y = 0.25;
  scene.crop.upper.y = 0.75;
  scene.transferFunction = {unit,
                            {{0.0, glm::dvec3(0.0), 0.0}, {1.0, glm::dvec3(1.0), -std::expm1(-8.0 * unit)}}};
  double before = 0.0;
  for (int samples = 32; samples <= 512; samples *= 2) {
    scene.quality.stepVoxels = 1.0 / samples;
    const double error = std::abs(renderReference(scene, {1, 1}, 1).pixels[0].r - exact);
    if (before > 0.0) {
      const double order = std::log2(before / error);
      EXPECT_GT(order, 1.8) << samples;
      EXPECT_LT(order, 2.2) << samples;
    }
    before = error;
  }
}

TEST(ReferenceIntegrator, alphaIsTheSameFromBehind) {
  Scene scene = smallPhantom();
  scene.shading.model = ShadingModel::none;
  scene.quality.earlyTermination = 1.0;
  scene.camera.projection = Camera::Projection::orthographic;
  scene.camera.heightMm = 300.0;
  const ReferencePicture front = renderReference(scene, {41, 30});
  scene.camera = standardView(scene.camera, scene.volume->grid(), StandardView::posterior);
  scene.camera.heightMm = 300.0;
  const ReferencePicture back = renderReference(scene, {41, 30});
  for (int y = 0; y < 30; ++y)
    for (int x = 0; x < 41; ++x)
      EXPECT_NEAR(front.pixels[static_cast<std::size_t>(y * 41 + x)].a,
                  back.pixels[static_cast<std::size_t>(y * 41 + 40 - x)].a, 1e-12);
}

} // namespace
} // namespace limn
