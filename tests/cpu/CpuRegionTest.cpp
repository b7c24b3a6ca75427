// SPDX-License-Identifier: GPL-3.0-or-later
// What of a volume is kept, drawn by the CPU engine (DEFINITION section 10): where a block is kept wholly its
// weights are not read, which changes no bit and makes a cut cheap.
#include "cpu/CpuRenderer.h"
#include "cpu/RegionStore.h"
#include "scene/light/Shading.h"
#include "support/JudgedTime.h"
#include "support/LookScenes.h"

#include <gtest/gtest.h>

#include <string>

namespace limn {
namespace {

// The phantom with a ball of label 1 taken out, or left by a weight.
Scene withBall(Scene scene, const std::vector<double>& weights, const glm::dvec3& middle, double radius) {
  const glm::ivec3 dims = scene.volume->grid().dims;
  std::vector<std::uint8_t> places(static_cast<std::size_t>(dims.x) * dims.y * dims.z, std::uint8_t{0});
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i)
        if (glm::distance(glm::dvec3(i, j, k), middle * glm::dvec3(dims - 1)) < radius)
          places[voxelOffset(dims, i, j, k)] = static_cast<std::uint8_t>(weights.size() - 1);
  std::vector<Label> labels(weights.size());
  for (std::size_t place = 0; place < labels.size(); ++place)
    labels[place].value = static_cast<int>(place);
  scene.keep = {Region::Kind::labels, "ball",
                std::make_shared<const LabelMap>(dims, std::move(places), std::move(labels)), weights};
  return scene;
}

TEST(CpuRegion, weightsThatAreNotReadChangeNoBit) {
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced})
    for (const std::vector<double>& weights :
         {std::vector<double>{1.0, 0.0}, {1.0, 0.4}, {0.0, 1.0}, {0.6, 0.3, 1.0}, {1.0, 0.25, 0.7}}) {
      Scene scene =
          withBall(headScene(phantomVolume({.spacingMm = 6.0}), model), weights, {0.4, 0.3, 0.5}, 9.0);
      for (const auto& [choice, step, tolerance] :
           {std::tuple{Preintegration::never, 0.5, std::optional<double>()},
            {Preintegration::always, 3.0, {}},
            {Preintegration::never, 1.0, 1.0}}) {
        scene.quality.preintegrated = choice;
        scene.quality.stepVoxels = step;
        scene.quality.toleranceLevels = tolerance;
        scene.quality.fineness = 4.75;
        CpuRenderer steps(1), reads(1, CpuRenderer::EmptySpace::sampled);
        EXPECT_EQ(steps.render(scene, {61, 53}).pixels, reads.render(scene, {61, 53}).pixels)
            << nameOf(model) << ", " << weights.size() << " labels, step " << step
            << (tolerance ? ", cell by cell" : "");
      }
    }
}

TEST(CpuRegion, blocksAreWholeOnlyWhereEverythingIsKept) {
  const Scene plain = headScene(phantomVolume({.spacingMm = 6.0}), ShadingModel::classic);
  const auto wholeOf = [&](const std::vector<double>& weights) {
    const Scene scene = withBall(plain, weights, {0.5, 0.5, 0.5}, 8.0);
    cpu::RegionStore store;
    const glm::ivec3 blocks = blocksOf(scene.volume->grid().dims);
    store.update(scene.keep, {glm::ivec3(0), blocks}, scene.volume->room(), {});
    return std::pair(blocks, std::vector<int>(store.whole().begin(), store.whole().end()));
  };
  const auto [blocks, ofCut] = wholeOf({1.0, 0.0});
  EXPECT_GT(ofCut.front(), 1) << "kept, and far from what is not";
  EXPECT_EQ(ofCut[voxelOffset(blocks, blocks.x / 2, blocks.y / 2, blocks.z / 2)], 0);
  const std::vector<int> ofHalves = wholeOf({0.5, 1.0}).second;
  EXPECT_EQ(ofHalves.front(), 0);
}

TEST(CpuRegion, oneCutTakesLittleMoreTimeThanNone) {
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced})
    for (const auto tolerance : {std::optional<double>(), std::optional<double>(1.0)}) {
      Scene plain = test::sceneToTime();
      plain.keep = {};
      plain.shading.model = model;
      plain.quality.toleranceLevels = tolerance;
      plain.quality.fineness = 4.75;
      // Behind what is seen, so that both draw the same.
      const Scene cut = withBall(plain, {1.0, 0.0}, {0.5, 0.9, 0.2}, 20.0);
      constexpr glm::ivec2 size(160, 160);
      CpuRenderer one, other;
      one.render(plain, size);
      other.render(cut, size);
      std::vector<double> without, with;
      for (int run = 0; run < 5; ++run) { // in turns: a machine that slows slows both
        without.push_back(test::lookMsOf([&] { one.render(plain, size); }));
        with.push_back(test::lookMsOf([&] { other.render(cut, size); }));
      }
      test::judgeMs(std::string("one cut, ") + nameOf(model) + (tolerance ? ", cell by cell" : ""),
                    test::medianLookMs(with), 1.1 * test::medianLookMs(without));
    }
}

} // namespace
} // namespace limn
