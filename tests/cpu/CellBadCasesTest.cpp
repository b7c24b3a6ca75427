// SPDX-License-Identifier: GPL-3.0-or-later
// What makes integration cell by cell go wrong: curves with steps, needles and 500 points; constant, binary
// and noisy fields; one voxel; voxels at both ends of 16 bits beside each other; rays on faces, edges and
// through corners of cells, and from inside. Each against the reference by cells in double, and against its
// equal steps, which know nothing of cells: the finer those are the nearer they come.
#include "cpu/CpuRenderer.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/basics/Error.h"
#include "scene/light/Shading.h"
#include "scene/steps/LocalSteps.h"
#include "scene/volume/Phantom.h"
#include "scene/volume/Volume.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/ImageCompare.h"
#include "support/JudgedTime.h"
#include "support/LongestWait.h"
#include "support/Sanitizers.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace limn {
namespace {

constexpr glm::ivec2 badPicture{25, 20};

std::shared_ptr<const Volume> volumeWith(const glm::ivec3& dims,
                                         const std::function<int(int, int, int)>& at) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = {1.0, 1.25, 0.8};
  std::vector<std::int16_t> voxels;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        voxels.push_back(static_cast<std::int16_t>(at(x, y, z)));
  return std::make_shared<const Volume>(grid, voxels, Rescale{}, std::nullopt, VolumeInfo{});
}

std::shared_ptr<const Volume> noise() {
  std::mt19937 random(5);
  return volumeWith({9, 8, 10}, [&](int, int, int) { return static_cast<int>(random() % 1000); });
}

Scene sceneOf(std::shared_ptr<const Volume> volume, ShadingModel model) {
  Scene scene;
  scene.camera = orbited(defaultCamera(volume->grid()), 0.5, 0.3);
  scene.volume = std::move(volume);
  scene.transferFunction = {2.0, {{100.0, {0.9, 0.4, 0.2}, 0.02}, {900.0, {0.3, 0.8, 1.0}, 0.6}}};
  scene.shading.model = model;
  scene.quality.earlyTermination = 1.0;
  return scene;
}

// At random, with opacities of up to half of `most`.
TransferFunction manyPoints(double most) {
  TransferFunction many{2.0, {}};
  std::mt19937 random(9);
  for (int k = 0; k < 500; ++k)
    many.points.push_back({2.0 * k, glm::dvec3(random() % 100, random() % 100, random() % 100) / 100.0,
                           most * static_cast<double>(random() % 50) / 100.0});
  return many;
}

Scene byCells(Scene scene, double fineness) {
  scene.quality.toleranceLevels = 1.0;
  scene.quality.fineness = fineness;
  return scene;
}

double averageApart(const ReferencePicture& a, const ReferencePicture& b) {
  return test::differenceOf(toImage(a), b, [](std::size_t) { return true; }).mean;
}

// In floats as in double, and both what ever finer steps come to.
void expectExact(const Scene& scene, const std::string& what, double finest = 1.0 / 256.0) {
  const ReferencePicture exact = renderReference(byCells(scene, 20.0), badPicture);
  CpuRenderer renderer;
  const test::Difference floats = test::differenceOf(renderer.render(byCells(scene, 14.0), badPicture), exact,
                                                     [](std::size_t) { return true; });
  // Floats place both sides of a needle of 1/2000 of the range to 6e-8 of it: 2.4e-4 of what it absorbs, and
  // as much of its light, which is at most all there is.
  EXPECT_LE(floats.largest, 0.2) << what << ": " << floats;
  Scene equal = scene;
  equal.quality.preintegrated = Preintegration::always;
  equal.quality.stepVoxels = 16.0 * finest;
  const double coarse = averageApart(renderReference(equal, badPicture), exact);
  equal.quality.stepVoxels = finest;
  const double fine = averageApart(renderReference(equal, badPicture), exact);
  // Steps err by the step itself where the field bends or light jumps: in the mean by a sixteenth, and twice
  // that.
  EXPECT_LE(fine, std::max(coarse / 8.0, 0.01)) << what << ": " << coarse;
}

TEST(CellBadCases, curvesWithStepsNeedlesAndManyPoints) {
  const auto volume = noise();
  TransferFunction steps{2.0, {{0.0, white, 0.0}}};
  for (int k = 1; k < 8; ++k) {
    const glm::dvec3 color(k % 2, 0.5, 1.0 - k / 8.0);
    steps.points.push_back({120.0 * k, steps.points.back().color, steps.points.back().opacity});
    steps.points.push_back({120.0 * k, color, k % 3 == 0 ? 0.0 : 0.1 * k});
  }
  TransferFunction needles{2.0, {}};
  for (int k = 0; k < 5; ++k)
    for (const auto& [at, opacity] : {std::pair{-0.5, 0.0}, std::pair{0.0, 1.0}, std::pair{0.5, 0.0}})
      needles.points.push_back({100.0 + 180.0 * k + at, {1.0, 0.2 * k, 0.1}, opacity});
  const TransferFunction many = manyPoints(1.0);
  const TransferFunction opaque{2.0, {{0.0, {0.2, 0.9, 0.4}, 1.0}, {1000.0, {0.9, 0.1, 0.6}, 1.0}}};
  for (const auto& [function, what] : {std::pair{steps, "steps"}, std::pair{needles, "needles"},
                                       std::pair{many, "500 points"}, std::pair{opaque, "opacity 1"}})
    for (const ShadingModel model : {ShadingModel::none, ShadingModel::robust}) {
      Scene scene = sceneOf(volume, model);
      scene.transferFunction = function;
      // Where gradients change what absorbs, steps wider than a needle do not come nearer yet.
      const bool isNarrow = function == needles && model == ShadingModel::robust;
      expectExact(scene, std::string(what) + ", " + nameOf(model), isNarrow ? 1.0 / 4096.0 : 1.0 / 256.0);
    }
}

TEST(CellBadCases, fieldsThatAreFlatJumpOrHaveHardlyAnyVoxels) {
  const std::pair<const char*, std::shared_ptr<const Volume>> volumes[] = {
      {"constant", volumeWith({6, 5, 7}, [](int, int, int) { return 500; })},
      {"binary",
       volumeWith({8, 8, 8}, [](int x, int y, int z) { return (x + y / 2 + z / 3) % 3 ? 0 : 900; })},
      {"one voxel", volumeWith({1, 1, 1}, [](int, int, int) { return 700; })},
      {"a row", volumeWith({7, 1, 1}, [](int x, int, int) { return 150 * x; })},
      {"a slice", volumeWith({5, 6, 1}, [](int x, int y, int) { return 100 * x + 70 * y; })},
      {"half flat", volumeWith({8, 7, 6}, [](int x, int, int) { return x < 4 ? 400 : 100 * x; })}};
  for (const auto& [what, volume] : volumes)
    for (const ShadingModel model : localModels)
      expectExact(sceneOf(volume, model), std::string(what) + ", " + nameOf(model));
}

TEST(CellBadCases, bothEndsOf16BitsBesideEachOther) {
  const auto volume =
      volumeWith({6, 6, 6}, [](int x, int y, int z) { return (x + y + z) % 2 ? 32767 : -32768; });
  Scene scene = sceneOf(volume, ShadingModel::enhanced);
  scene.transferFunction = {2.0, {{-32768.0, {0.9, 0.4, 0.2}, 0.02}, {32767.0, {0.3, 0.8, 1.0}, 0.6}}};
  expectExact(scene, "16 bits");
}

TEST(CellBadCases, raysOnFacesAndEdgesThroughCornersAndFromInside) {
  const auto volume = noise();
  const Scene base = sceneOf(volume, ShadingModel::robust);
  // Two pixels a voxel, seen along y: every second column of rays runs in faces between cells.
  Grid cubes;
  cubes.dims = {9, 9, 9};
  std::mt19937 random(6);
  Scene along = base;
  along.volume = volumeOf(cubes, [&](int, int, int) { return static_cast<double>(random() % 1000); });
  along.camera = defaultCamera(cubes);
  along.camera.projection = Camera::Projection::orthographic;
  along.camera.heightMm = 0.5 * badPicture.y;
  expectExact(along, "in faces");
  // Rows as well: along edges.
  along.camera.position.z += 0.25;
  along.camera.target.z += 0.25;
  expectExact(along, "along edges");
  Scene diagonal = base;
  diagonal.camera.projection = Camera::Projection::orthographic;
  const glm::dvec3 corner = volume->grid().spacingMm;
  diagonal.camera.position = diagonal.camera.target + 40.0 * corner;
  expectExact(diagonal, "through corners");
  Scene inside = base;
  inside.camera.position = inside.camera.target + glm::dvec3(0.3, -0.7, 0.2);
  expectExact(inside, "from inside");
}

// A large picture that the field fills is begun and given up after so many strips; whoever cancels meanwhile,
// at whatever moment, waits for less than 50 ms.
void expectGivenUp(const Scene& scene, const std::string& what) {
  SCOPED_TRACE(what);
  constexpr double mostMs = 50.0;
  constexpr glm::ivec2 size(3000, 3000);
  // All of it, which asks 550 times before anything is drawn, and rows through the middle, where rays are
  // longest.
  constexpr std::pair<PixelRect, int> parts[] = {{{{0, 0}, size}, 750}, {{{0, 1500}, {3000, 128}}, 200}};
  for (const auto& [part, most] : parts) {
    const auto wait = test::waitOf(mostMs, [&, &part = part, most = most](test::LongestWait& longest) {
      CpuRenderer renderer;
      const auto isCancelled = [&] {
        longest.asked();
        return longest.count() > most;
      };
      EXPECT_THROW(renderer.draw(scene, size, part, isCancelled), Cancelled);
      longest.asked();
    });
    test::judgeMs("a picture of 3,000² is given up, " + what, wait.clockMs(), mostMs);
    std::printf("%s: %.1f ms of the processor at most\n", what.c_str(), wait.cpuMs());
    LIMN_NEEDS_ITS_OWN_TIME;
    EXPECT_LE(wait.cpuMs(), mostMs);
  }
}

Scene filling(Scene scene) {
  scene.camera = zoomed(scene.camera, 4.0);
  return scene;
}

TEST(CellBadCases, aLargePictureIsGivenUpWithinMoments) {
  Scene head =
      byCells(headScene(phantomVolume({.spacingMm = 2.0}), ShadingModel::robust), usualFineness(1.0));
  head.quality.earlyTermination = 0.998;
  expectGivenUp(head, "phantom");
  expectGivenUp(filling(head), "phantom, filling it");
  Scene thin = head;
  thin.transferFunction = {1.0, {{-1000.0, white, 0.0}, {0.0, white, 0.01}, {1500.0, white, 0.3}}};
  thin.quality.earlyTermination = 1.0;
  expectGivenUp(filling(thin), "thin tissue that no ray ends in");
}

// The dearest pixels: noise of a hundred cells on end, a function of 500 points, of which each cell has many.
TEST(CellBadCases, aLargePictureOfTheDearestRaysIsGivenUpWithinMoments) {
  std::mt19937 random(5);
  Scene scene =
      byCells(sceneOf(volumeWith({100, 100, 100}, [&](int, int, int) { return int(random() % 1000); }),
                      ShadingModel::robust),
              usualFineness(1.0));
  scene.transferFunction = manyPoints(0.02);
  expectGivenUp(filling(scene), "noise under 500 points");
}

} // namespace
} // namespace limn
