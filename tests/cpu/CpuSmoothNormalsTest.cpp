// SPDX-License-Identifier: GPL-3.0-or-later
// Smooth normals drawn by the CPU engine (DEFINITION section 2): as the reference draws them, and without a
// trace where there are none.
#include "cpu/CpuRenderer.h"
#include "cpu/bricks/BrickRenderer.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/light/Shading.h"
#include "scene/steps/RayFrame.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/Heads.h"
#include "support/ImageCompare.h"
#include "support/TestData.h"

#include <gtest/gtest.h>

#include <iostream>

namespace limn {
namespace {

constexpr glm::ivec2 smoothSize{96, 80};

Scene smoothed(std::shared_ptr<const Volume> volume, ShadingModel model, double sigmaMm) {
  Scene scene = headScene(std::move(volume), model);
  scene.camera = orbited(scene.camera, 0.5, 0.3);
  scene.shading.gradientSmoothing = sigmaMm;
  return scene;
}

// The engine's bounds without it.
void expectSmoothAsReference(const Scene& scene, const std::string& what) {
  CpuRenderer renderer;
  const test::Difference difference =
      test::differenceOf(renderer.render(scene, smoothSize), renderReference(scene, smoothSize),
                         [](std::size_t) { return true; });
  std::cout << what << ": " << difference << "\n";
  EXPECT_LE(difference.largest, 0.5) << what;
  EXPECT_LE(difference.mean, 0.01) << what;
  EXPECT_GE(difference.pixels, 100u) << what;
}

struct SmoothCase {
  const char* what;
  void (*apply)(Scene&);
};

const SmoothCase smoothCases[] = {
    {"classic", [](Scene& s) { s.shading.model = ShadingModel::classic; }},
    {"enhanced", [](Scene&) {}},
    {"robust", [](Scene& s) { s.shading.model = ShadingModel::robust; }},
    {"cell by cell",
     [](Scene& s) {
       s.quality.toleranceLevels = 1.0;
       s.quality.fineness = 4.75;
     }},
    {"classic, cell by cell",
     [](Scene& s) {
       s.shading.model = ShadingModel::classic;
       s.quality.toleranceLevels = 1.0;
       s.quality.fineness = 4.75;
     }},
    {"in pre-integrated steps", [](Scene& s) { s.quality.preintegrated = Preintegration::always; }},
    {"unlit, with gradient opacity",
     [](Scene& s) {
       s.shading.model = ShadingModel::none;
       s.gradientOpacity = GradientOpacity{{{0.0, 0.05}, {60.0, 1.0}}};
     }},
    {"a surface", [](Scene& s) { s.projection = Projection::isosurface; }},
    {"up to a surface, cropped",
     [](Scene& s) {
       s.projection = Projection::compositeIsosurface;
       s.crop = {{0.1, 0.3, 0.0}, {0.9, 1.0, 0.8}};
     }},
    {"a kept region",
     [](Scene& s) {
       s.keep = cubesRegion(s.volume->grid().dims, 7, {1.0, 0.0, 0.4});
     }},
    {"looks of labels",
     [](Scene& s) {
       s.keep = withVariedLooks(cubesRegion(s.volume->grid().dims, 9, {1.0, 1.0, 0.6}), s.transferFunction);
     }},
};

TEST(CpuSmoothNormals, areTheReferences) {
  const auto phantom = phantomVolume({.spacingMm = 4.0});
  for (const SmoothCase& one : smoothCases) {
    Scene scene = smoothed(phantom, ShadingModel::enhanced, 5.0);
    one.apply(scene);
    expectSmoothAsReference(scene, one.what);
  }
  for (const double sigma : {1.4, 20.0})
    expectSmoothAsReference(smoothed(phantom, ShadingModel::enhanced, sigma), "other widths");
  expectSmoothAsReference(
      smoothed(phantomVolume({.spacingMm = 3.0, .noiseHu = 20.0}), ShadingModel::enhanced, 3.0), "noise");
}

TEST(CpuSmoothNormals, ofTheCtHeadAreTheReferences) {
  LIMN_NEEDS_SHARED(test::ctHeadFile);
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced, ShadingModel::robust})
    expectSmoothAsReference(smoothed(test::ctHead(), model, 1.05), std::string("CT head, ") + nameOf(model));
}

// Voxels of a few slices in other types.
template <class T>
void compareSmoothType(const glm::ivec3& dims, const std::string& what) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = {1.0, 0.8, 4.7};
  std::vector<T> voxels;
  std::uint32_t state = 7;
  for (int n = 0; n < dims.x * dims.y * dims.z; ++n) {
    state = state * 1664525u + 1013904223u;
    voxels.push_back(static_cast<T>(100.0 * (state >> 8) / 16777216.0));
  }
  Scene scene;
  scene.volume = std::make_shared<const Volume>(grid, voxels, Rescale{-2.0, 5.0}, std::nullopt, VolumeInfo{});
  scene.transferFunction = {1.0, {{-200.0, {0.9, 0.5, 0.2}, 0.4}, {10.0, {0.2, 0.5, 0.9}, 0.01}}};
  scene.camera = defaultCamera(grid);
  scene.camera = orbited(scene.camera, 0.7, 0.4);
  scene.shading.model = ShadingModel::enhanced;
  scene.shading.gradientSmoothing = 3.3;
  scene.quality.stepVoxels = 0.25;
  expectSmoothAsReference(scene, what);
}

TEST(CpuSmoothNormals, agreeInEveryTypeAndInFewVoxels) {
  compareSmoothType<std::uint8_t>({20, 22, 5}, "bytes");
  compareSmoothType<std::int16_t>({20, 22, 5}, "16 bits");
  compareSmoothType<float>({20, 22, 5}, "floats");
  compareSmoothType<double>({20, 22, 5}, "doubles");
  compareSmoothType<std::int16_t>({20, 22, 1}, "one slice");
  compareSmoothType<std::int16_t>({20, 2, 3}, "two rows");
}

TEST(CpuSmoothNormals, underLightOnItsWayAreTheReferences) {
  Scene scene = smoothed(phantomVolume({.spacingMm = 8.0}), ShadingModel::enhanced, 8.0);
  scene.shading.lightDirection = glm::dvec3(0.6, -0.7, 1.0);
  scene.shading.lightAxes = LightAxes::camera;
  scene.shading.shadow = {0.85, 5.0};
  scene.shading.occlusion = {0.8, 15.0};
  scene.quality.light = LightDetail::sampled;
  CpuRenderer renderer;
  const glm::ivec2 size{20, 18};
  const test::Difference difference = test::differenceOf(
      renderer.render(scene, size), renderReference(scene, size), [](std::size_t) { return true; });
  std::cout << difference << "\n";
  // As without smoothing (CpuTravellingLightTest): what a tolerance of one level asks for in the 99.9th
  // percentile; of 360 pixels that is about the largest.
  EXPECT_LE(difference.largest, 1.5);
  EXPECT_LE(difference.mean, 0.1);
  // Light is found anew where the field behind it is another: on a grid, which is kept.
  scene.quality.light = LightDetail::fine;
  const Image first = renderer.render(scene, size);
  scene.shading.gradientSmoothing = 0.0;
  const Image without = renderer.render(scene, size);
  EXPECT_EQ(without, CpuRenderer().render(scene, size));
  scene.shading.gradientSmoothing = 8.0;
  EXPECT_EQ(renderer.render(scene, size), first);
}

TEST(CpuSmoothNormals, leaveNoTraceWhereThereAreNone) {
  const auto phantom = phantomVolume({.spacingMm = 4.0});
  CpuRenderer renderer;
  const Scene without = smoothed(phantom, ShadingModel::enhanced, 0.0);
  const Image plain = renderer.render(without, smoothSize);
  const double mb = renderer.memoryMb();
  Scene scene = smoothed(phantom, ShadingModel::enhanced, 1.3); // 3σ is less than a voxel
  EXPECT_EQ(renderer.render(scene, smoothSize), plain);
  EXPECT_EQ(renderer.memoryMb(), mb);
  scene.shading.gradientSmoothing = 6.0;
  EXPECT_NE(renderer.render(scene, smoothSize), plain);
  // A float for each voxel.
  EXPECT_NEAR(renderer.memoryMb() - mb, 4e-6 * static_cast<double>(phantom->voxelCount()), 1e-9);
  scene.projection = Projection::mip;
  Scene mip = without;
  mip.projection = Projection::mip;
  EXPECT_EQ(renderer.render(scene, smoothSize), CpuRenderer().render(mip, smoothSize));
  EXPECT_EQ(renderer.render(without, smoothSize), plain);
  // What was made stays for pictures that take turns, and goes with its volume.
  EXPECT_GT(renderer.memoryMb(), mb);
  EXPECT_EQ(
      renderer.render(smoothed(phantomVolume({.spacingMm = 4.0}), ShadingModel::enhanced, 0.0), smoothSize),
      plain);
  EXPECT_EQ(renderer.memoryMb(), mb);
}

TEST(CpuSmoothNormals, areTheSameOnAnyNumberOfThreadsInTilesAndWithoutLeaps) {
  const Scene scene = smoothed(phantomVolume({.spacingMm = 3.0}), ShadingModel::enhanced, 5.0);
  const Image whole = CpuRenderer(1).render(scene, smoothSize);
  EXPECT_EQ(CpuRenderer(4).render(scene, smoothSize), whole);
  EXPECT_EQ(CpuRenderer(2, CpuRenderer::EmptySpace::sampled).render(scene, smoothSize), whole);
  CpuRenderer tiles;
  const PixelRect tile{{31, 17}, {29, 40}};
  const Image part = tiles.draw(scene, smoothSize, tile);
  for (int y = 0; y < tile.size.y; ++y)
    for (int x = 0; x < tile.size.x; ++x)
      ASSERT_EQ(
          part.pixels[static_cast<std::size_t>(y) * tile.size.x + x],
          whole.pixels[static_cast<std::size_t>(y + tile.topLeft.y) * smoothSize.x + x + tile.topLeft.x]);
}

TEST(CpuSmoothNormals, leftOutTheyCostNothingMore) {
  const Scene scene = smoothed(phantomVolume({.spacingMm = 4.0}), ShadingModel::classic, 5.0);
  CpuRenderer renderer;
  const PixelRect all{{0, 0}, smoothSize};
  const Image with = renderer.render(scene, smoothSize);
  const Image without = renderer.drawWithout({Effect::smoothNormals}, scene, smoothSize, all);
  EXPECT_NE(with, without);
  EXPECT_EQ(renderer.drawWithout({}, scene, smoothSize, all), with);
}

TEST(CpuSmoothNormals, areCancelledWhileTheyAreMade) {
  const Scene scene = smoothed(phantomVolume({.spacingMm = 1.5}), ShadingModel::enhanced, 6.0);
  Scene without = scene;
  without.shading.gradientSmoothing = 0.0;
  CpuRenderer renderer;
  renderer.plan(without);
  int asked = 0;
  EXPECT_THROW(renderer.draw(scene, smoothSize, {{0, 0}, smoothSize}, [&] { return ++asked > 3; }),
               Cancelled);
  EXPECT_EQ(renderer.render(scene, smoothSize), CpuRenderer().render(scene, smoothSize));
}

TEST(CpuSmoothNormals, areRefusedInBricks) {
  const Scene scene = smoothed(phantomVolume({.spacingMm = 8.0}), ShadingModel::enhanced, 9.0);
  BrickRenderer bricks(1);
  try {
    bricks.begin(scene, smoothSize, croppedBox(scene.volume->grid(), scene.crop));
    FAIL() << "drawn";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::usage);
    EXPECT_NE(std::string(error.what()).find("Smooth normals"), std::string::npos);
  }
}

} // namespace
} // namespace limn
