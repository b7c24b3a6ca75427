// SPDX-License-Identifier: GPL-3.0-or-later
// The CPU engine against the reference under the same discretisation. Both divide rays in double, so every
// ray has the same samples, and the bound is the product's: half an 8-bit level at most, 0.01 in the mean.
#include "cpu/CpuRenderer.h"
#include "scene/light/Shading.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/Heads.h"
#include "support/ImageCompare.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <iostream>

namespace limn {
namespace {

constexpr double largestLevels = 0.5;
constexpr double meanLevels = 0.01;

bool isEvery(std::size_t) {
  return true;
}

void expectAgreement(CpuRenderer& renderer, const Scene& scene, const glm::ivec2& size,
                     const std::string& what, std::size_t leastPixels = 100) {
  const Image image = renderer.render(scene, size);
  const test::Difference difference = test::differenceOf(image, renderReference(scene, size), isEvery);
  std::cout << what << ": " << difference << "\n";
  EXPECT_LE(difference.largest, largestLevels) << what;
  EXPECT_LE(difference.mean, meanLevels) << what;
  EXPECT_GE(difference.pixels, leastPixels) << what << " shows almost nothing";
}

void compareModels(const std::shared_ptr<const Volume>& volume, double earlyTermination) {
  CpuRenderer renderer;
  for (const ShadingModel model :
       {ShadingModel::none, ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust}) {
    Scene scene = test::headScene(volume, model);
    scene.quality.earlyTermination = earlyTermination;
    expectAgreement(renderer, scene, {256, 256}, nameOf(model));
  }
}

TEST(CpuAgainstReference, allModelsAgreeOnThePhantom) {
  compareModels(phantomVolume({.spacingMm = 1.5}), 1.0);
}

TEST(CpuAgainstReference, allModelsAgreeOnANoisyPhantomWithEarlyTermination) {
  compareModels(phantomVolume({.spacingMm = 2.0, .noiseHu = 20.0}), Quality{}.earlyTermination);
}

TEST(CpuAgainstReference, allModelsAgreeOnTheCtHead) {
  LIMN_NEEDS_SHARED(test::ctHeadFile);
  compareModels(test::ctHead(), 1.0);
}

TEST(CpuAgainstReference, everyParameterShowsAsTheReferenceShowsIt) {
  CpuRenderer renderer;
  Scene base = test::headScene(phantomVolume({.spacingMm = 4.0}), ShadingModel::robust);
  base.quality.preintegrated = Preintegration::never;
  for (const Variation& variation : everyParameter()) {
    Scene scene = base;
    variation.apply(scene);
    // The smallest value of every ray is air, which this curve does not show.
    expectAgreement(renderer, scene, {48, 40}, variation.what,
                    scene.projection == Projection::minip ? 0 : 100);
  }
}

void compareProjections(const Scene& base, const std::string& what) {
  CpuRenderer renderer;
  for (const Projection projection :
       {Projection::composite, Projection::mip, Projection::minip, Projection::average, Projection::xray,
        Projection::isosurface, Projection::compositeIsosurface})
    for (const auto preintegrated : {Preintegration::never, Preintegration::always})
      for (const auto tolerance : {std::optional<double>(), std::optional<double>(1.0)}) {
        Scene scene = base;
        scene.projection = projection;
        scene.isovalue = 300.0;
        scene.quality.preintegrated = preintegrated;
        scene.quality.toleranceLevels = tolerance;
        scene.quality.fineness = 4.75;
        // The smallest value of every ray is air, which this curve does not show.
        if (projection == Projection::minip)
          scene.transferFunction.points.insert(scene.transferFunction.points.begin(),
                                               {-1000.0, {0.2, 0.4, 0.9}, 0.6});
        expectAgreement(renderer, scene, {80, 64},
                        what + "projection " + std::to_string(static_cast<int>(projection)));
      }
}

TEST(CpuAgainstReference, everyProjectionAndKindOfStepAgrees) {
  compareProjections(test::headScene(phantomVolume({.spacingMm = 3.0}), ShadingModel::enhanced), "");
}

TEST(CpuAgainstReference, everyProjectionAndKindOfStepOfAKeptRegionAgrees) {
  Scene scene = test::headScene(phantomVolume({.spacingMm = 3.0}), ShadingModel::enhanced);
  scene.camera = orbited(scene.camera, 0.5, 0.3); // no sample in a plane between two voxels
  for (const std::vector<double>& weights : {std::vector{0.0, 1.0}, std::vector{0.0, 1.0, 0.4}}) {
    scene.keep = cubesRegion(scene.volume->grid().dims, 9, weights);
    compareProjections(scene, "region, ");
  }
}

// Voxels of every stored type, in volumes of few voxels too.
template <class T>
void compareType(const glm::ivec3& dims, double lowest, double highest, const std::string& what) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = {1.0, 0.8, 1.7};
  std::vector<T> voxels;
  std::uint32_t state = 7;
  for (int n = 0; n < dims.x * dims.y * dims.z; ++n) {
    state = state * 1664525u + 1013904223u;
    voxels.push_back(static_cast<T>(lowest + (highest - lowest) * (state >> 8) / 16777216.0));
  }
  Scene scene;
  scene.volume = std::make_shared<const Volume>(grid, voxels, Rescale{-2.0, 5.0}, std::nullopt, VolumeInfo{});
  const ValueRange& range = scene.volume->range();
  scene.transferFunction = {1.0,
                            {{range.lowest, {0.1, 0.5, 0.9}, 0.1}, {range.highest, {1.0, 0.6, 0.2}, 0.7}}};
  scene.camera = orbited(defaultCamera(grid), 0.5, 0.4);
  scene.shading.model = ShadingModel::classic;
  scene.quality.preintegrated = Preintegration::never;
  CpuRenderer renderer;
  const glm::ivec2 size(24, 20);
  const Image image = renderer.render(scene, size);
  const test::Difference difference = test::differenceOf(image, renderReference(scene, size), isEvery);
  EXPECT_LE(difference.largest, largestLevels) << what;
  EXPECT_GT(difference.pixels, 0u) << what;
}

TEST(CpuAgainstReference, everyStoredTypeAndShapeAgrees) {
  for (const glm::ivec3& dims : {glm::ivec3(1), glm::ivec3(1, 1, 5), glm::ivec3(6, 1, 1), glm::ivec3(1, 7, 1),
                                 glm::ivec3(2, 3, 1), glm::ivec3(3, 2, 2), glm::ivec3(9, 7, 11)}) {
    const std::string shape =
        std::to_string(dims.x) + "x" + std::to_string(dims.y) + "x" + std::to_string(dims.z);
    compareType<std::uint8_t>(dims, 0, 255, "uint8 " + shape);
    compareType<std::int8_t>(dims, -128, 127, "int8 " + shape);
    compareType<std::uint16_t>(dims, 0, 65535, "uint16 " + shape);
    compareType<std::uint16_t>(dims, 65500, 65535, "uint16, a narrow range " + shape);
    compareType<std::int16_t>(dims, -32768, 32767, "int16 " + shape);
    compareType<std::uint32_t>(dims, 0, 4e9, "uint32 " + shape);
    compareType<std::int32_t>(dims, -2e9, 2e9, "int32 " + shape);
    compareType<float>(dims, -1e30, 1e30, "float " + shape);
    compareType<double>(dims, -1e200, 1e200, "double " + shape);
  }
}

} // namespace
} // namespace limn
