// SPDX-License-Identifier: GPL-3.0-or-later
// Which looks of labels count, their shares at a place, and what follows for blocks, steps and what is
// visible.
#include "scene/LabelLooks.h"
#include "scene/effects/EffectPlan.h"
#include "scene/framing/VisibleVoxels.h"
#include "scene/regions/BlockLooks.h"
#include "scene/regions/LabelColor.h"
#include "scene/regions/Reduction.h"
#include "scene/steps/BlockWalk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace limn {
namespace {

constexpr glm::ivec3 lookDims{19, 14, 11};

// Random labels 0 … 3 in boxes; values that rise along x.
Scene labelledScene(unsigned seed, const std::vector<double>& weights) {
  std::mt19937 random(seed);
  std::vector<std::uint8_t> places(static_cast<std::size_t>(lookDims.x) * lookDims.y * lookDims.z, 0);
  for (int box = 0; box < 9; ++box) {
    const auto label = static_cast<std::uint8_t>(random() % weights.size());
    const glm::ivec3 from(random() % 15, random() % 10, random() % 8);
    for (int z = from.z; z < std::min(from.z + 5, lookDims.z); ++z)
      for (int y = from.y; y < std::min(from.y + 6, lookDims.y); ++y)
        for (int x = from.x; x < std::min(from.x + 7, lookDims.x); ++x)
          places[voxelOffset(lookDims, x, y, z)] = label;
  }
  std::vector<Label> labels;
  for (std::size_t n = 0; n < weights.size(); ++n)
    labels.push_back({static_cast<int>(n), "", glm::dvec3(1.0)});
  std::vector<float> values;
  for (std::size_t n = 0; n < places.size(); ++n)
    values.push_back(static_cast<float>(n % lookDims.x) + 0.25f * static_cast<float>(random() % 8));
  Grid grid;
  grid.dims = lookDims;
  Scene scene;
  scene.volume = std::make_shared<const Volume>(grid, values, Rescale{}, std::nullopt, VolumeInfo{});
  scene.camera = defaultCamera(grid);
  scene.keep = {Region::Kind::labels, "s", std::make_shared<const LabelMap>(lookDims, places, labels),
                weights};
  return scene;
}

TransferFunction bandAt(double value, double unitDistanceMm = 1.0) {
  return {unitDistanceMm,
          {{value - 1.0, glm::dvec3(1.0), 0.0},
           {value, glm::dvec3(1.0), 0.8},
           {value + 1.0, glm::dvec3(1.0), 0.0}}};
}

TEST(LabelLooks, sharesAreTrilinearAndSumToOneAndTheirWeightsToTheRegions) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-1.0, 20.0);
  Scene scene = labelledScene(1, {1.0, 0.5, 0.0, 0.25});
  scene.transferFunction = bandAt(3.0);
  scene.keep = withLooks(scene.keep, {{1, bandAt(5.0)}, {2, bandAt(7.0)}, {3, bandAt(5.0)}});
  const LabelLooks looks = labelLooks(scene);
  ASSERT_TRUE(looks.areAny());
  EXPECT_EQ(looks.ofLabel[1], looks.ofLabel[3]) << "equal looks are one";
  for (int trial = 0; trial < 2000; ++trial) {
    const glm::dvec3 index(any(random), any(random), any(random));
    double sum = 0.0, weight = 0.0;
    const auto shares = lookSharesAt(looks, scene.keep, index);
    for (const LookShare& one : shares.used()) {
      EXPECT_GT(one.share, 0.0);
      sum += one.share;
      weight += one.share * one.weight;
    }
    ASSERT_NEAR(sum, 1.0, 1e-12);
    ASSERT_NEAR(weight, weightAt(scene.keep, index), 1e-12);
  }
}

TEST(LabelLooks, onlyWhatSomeVoxelShowsCounts) {
  Scene scene = labelledScene(5, {1.0, 1.0, 0.0, 1.0});
  scene.transferFunction = bandAt(3.0);
  EXPECT_FALSE(hasLabelLooks(scene));
  scene.keep = withLooks(scene.keep, {{1, scene.transferFunction}});
  EXPECT_FALSE(hasLabelLooks(scene)) << "the scene's own";
  scene.keep = withLooks(scene.keep, {{2, bandAt(9.0)}});
  EXPECT_FALSE(hasLabelLooks(scene)) << "of what is hidden";
  scene.keep = withLooks(scene.keep, {{1, bandAt(9.0)}});
  EXPECT_TRUE(hasLabelLooks(scene));
  scene.projection = Projection::mip;
  EXPECT_FALSE(hasLabelLooks(scene)) << "one value of a ray";
  scene.projection = Projection::composite;
  // A look of all labels that show is all that counts.
  scene.keep = withLooks(scene.keep, {{0, bandAt(9.0)}, {1, bandAt(9.0)}, {3, bandAt(9.0)}});
  EXPECT_TRUE(labelLooks(scene).functions.front().points.empty());
}

TEST(LabelLooks, ofOneLabelChangeWithoutTheOthers) {
  Region region = labelledScene(5, {1.0, 0.5, 0.0, 1.0}).keep;
  const Region before = region;
  region = withLookOf(region, 1, bandAt(9.0));
  region = withLookOf(region, 3, bandAt(9.0));
  EXPECT_EQ(region.looks.size(), 1u) << "equal ones are one";
  region = withLookOf(region, 3, bandAt(4.0));
  EXPECT_EQ(region.looks[lookOfLabel(region, 1) - 1], normalised(bandAt(9.0)));
  EXPECT_EQ(region.looks[lookOfLabel(region, 3) - 1], normalised(bandAt(4.0)));
  EXPECT_EQ(lookOfLabel(region, 2), 0u);
  EXPECT_EQ(withLookOf(withLookOf(region, 1, {}), 3, {}), before);
}

TEST(LabelLooks, areAnEffectOfTheirOwnBesidePreintegration) {
  Scene scene = labelledScene(3, {1.0, 1.0, 1.0, 1.0});
  scene.transferFunction = bandAt(3.0);
  scene.quality.preintegrated = Preintegration::always;
  EXPECT_FALSE(requiredEffects(scene, {}).effects.has(Effect::labelLooks));
  EXPECT_TRUE(requiredEffects(scene, {}).effects.has(Effect::preintegration));
  scene.keep = withLooks(scene.keep, {{1, bandAt(9.0)}});
  EXPECT_TRUE(requiredEffects(scene, {}).effects.has(Effect::labelLooks));
  EXPECT_TRUE(requiredEffects(scene, {}).effects.has(Effect::preintegration));
  // What the scene's own function does not show, a look may.
  scene.transferFunction.points.clear();
  EXPECT_TRUE(isAnythingVisible(scene));
}

TEST(LabelLooks, functionsWithCommonPointsAreTheSameFunctions) {
  const TransferFunction stepped{2.0,
                                 {{1.0, {0.1, 0.2, 0.3}, 0.1},
                                  {4.0, {0.4, 0.2, 0.9}, 0.6},
                                  {4.0, {0.9, 0.2, 0.9}, 0.2},
                                  {8.0, {0.4, 0.7, 0.9}, 0.9}}};
  const std::vector<TransferFunction> functions{bandAt(3.0), stepped, {1.0, {}}, bandAt(4.0, 0.5)};
  const std::vector<TransferFunction> common = withCommonPoints(functions);
  const TransferFunction all = unionOf(functions);
  for (double value = -1.0; value < 10.0; value += 1.0 / 64.0) {
    double most = 0.0;
    for (std::size_t i = 0; i < functions.size(); ++i) {
      const Classified exact = classify(functions[i], value), same = classify(common[i], value);
      ASSERT_NEAR(same.opacity, exact.opacity, 1e-12);
      if (exact.opacity > 0.0) {
        ASSERT_LE(glm::length(same.color - exact.color), 1e-12);
      }
      most = std::max(most, exact.opacity);
    }
    // Between points the largest of lines lies below the line between the largest.
    ASSERT_GE(classify(all, value).opacity, most - 1e-12);
    ASSERT_EQ(classify(all, value).opacity > 0.0, most > 0.0) << value;
  }
  for (std::size_t i = 0; i < functions.size(); ++i) {
    ASSERT_EQ(common[i].points.size(), all.points.size());
    EXPECT_EQ(common[i].unitDistanceMm, functions[i].unitDistanceMm);
  }
}

TEST(LabelLooks, blocksKnowTheLooksOfTheirVoxelsAndOfTheNextOnes) {
  const Scene scene = labelledScene(4, {1.0, 1.0, 1.0, 1.0});
  const std::vector<std::uint8_t> lookOf{0, 5, 2, 5};
  const glm::ivec3 blocks(5, 4, 3);
  const BlockLooks looks = blockLooks(*scene.keep.labels, lookOf, {blocks, glm::ivec3(4)});
  for (int k = 0; k < blocks.z; ++k)
    for (int j = 0; j < blocks.y; ++j)
      for (int i = 0; i < blocks.x; ++i) {
        LookBits expected = 0;
        for (int z = std::max(0, 4 * k - 1); z <= std::min(lookDims.z - 1, 4 * k + 5); ++z)
          for (int y = std::max(0, 4 * j - 1); y <= std::min(lookDims.y - 1, 4 * j + 5); ++y)
            for (int x = std::max(0, 4 * i - 1); x <= std::min(lookDims.x - 1, 4 * i + 5); ++x)
              expected |= LookBits{1} << lookOf[scene.keep.labels->placeAt(voxelOffset(lookDims, x, y, z))];
        ASSERT_EQ(looks[voxelOffset(blocks, i, j, k)], expected) << i << " " << j << " " << k;
      }
}

TEST(LabelLooks, aCellHasTheLookThatAllItsVoxelsHave) {
  const Scene scene = labelledScene(5, {1.0, 1.0, 1.0, 1.0});
  const RoomVector<std::uint8_t> looks = looksOfVoxels(*scene.keep.labels, {0, 5, 2, 5});
  const RoomVector<std::uint8_t> cells = cellLooks(lookDims, looks);
  int several = 0;
  for (int z = 0; z < lookDims.z; ++z)
    for (int y = 0; y < lookDims.y; ++y)
      for (int x = 0; x < lookDims.x; ++x) {
        std::set<std::uint8_t> there;
        for (int corner = 0; corner < 8; ++corner) {
          const glm::ivec3 at =
              glm::min(glm::ivec3(x + (corner & 1), y + (corner >> 1 & 1), z + (corner >> 2)), lookDims - 1);
          there.insert(looks[voxelOffset(lookDims, at.x, at.y, at.z)]);
        }
        ASSERT_EQ(cells[voxelOffset(lookDims, x, y, z)], there.size() == 1 ? *there.begin() : severalLooks);
        several += there.size() > 1 ? 1 : 0;
      }
  EXPECT_GT(several, 0);
}

TEST(LabelLooks, aPlaceHasTheLookOfItsCell) {
  Scene scene = labelledScene(5, {1.0, 1.0, 1.0, 1.0});
  scene.transferFunction = bandAt(3.0);
  scene.keep = withLooks(scene.keep, {{1, bandAt(5.0)}, {2, bandAt(7.0)}});
  const LabelLooks looks = labelLooks(scene);
  const RoomVector<std::uint8_t> cells =
      cellLooks(lookDims, looksOfVoxels(*scene.keep.labels, looks.ofLabel));
  for (int z = 0; z < lookDims.z; ++z)
    for (int y = 0; y < lookDims.y; ++y)
      for (int x = 0; x < lookDims.x; ++x) {
        const std::uint8_t cell = cells[voxelOffset(lookDims, x, y, z)];
        const auto expected = cell == severalLooks ? std::nullopt : std::optional<std::size_t>(cell);
        for (const double within : {0.0, 0.4, 0.99})
          ASSERT_EQ(lookOfCell(looks, scene.keep, glm::dvec3(x, y, z) + within), expected);
      }
  // Beyond the outermost centres it is theirs.
  EXPECT_EQ(lookOfCell(looks, scene.keep, glm::dvec3(-0.5)), lookOfCell(looks, scene.keep, glm::dvec3(0.0)));
  EXPECT_EQ(lookOfCell(looks, scene.keep, glm::dvec3(lookDims) - 0.5),
            looks.ofLabel[scene.keep.labels->placeAt(
                voxelOffset(lookDims, lookDims.x - 1, lookDims.y - 1, lookDims.z - 1))]);
}

TEST(LabelLooks, voxelsAreVisibleByTheLookOfTheirLabel) {
  Scene scene = labelledScene(6, {1.0, 0.02, 0.0, 1.0});
  scene.transferFunction = bandAt(3.0);
  scene.keep = withLooks(scene.keep, {{1, bandAt(12.0)}, {2, bandAt(5.0)}, {3, bandAt(15.0)}});
  const LabelLooks looks = labelLooks(scene);
  glm::ivec3 lower = lookDims, upper(0);
  std::size_t count = 0;
  visitVoxels(*scene.volume, [&](const auto& stored) {
    for (std::size_t voxel = 0; voxel < stored.size(); ++voxel) {
      const double weight = scene.keep.weights[scene.keep.labels->placeAt(voxel)];
      const double opacity =
          classify(functionAt(looks, scene.keep, voxel), static_cast<double>(stored[voxel])).opacity;
      if (!(weight * opacity >= visibleOpacity))
        continue;
      const auto n = static_cast<int>(voxel);
      const glm::ivec3 at(n % lookDims.x, n / lookDims.x % lookDims.y, n / lookDims.x / lookDims.y);
      lower = glm::min(lower, at);
      upper = glm::max(upper, at + 1);
      ++count;
    }
  });
  ASSERT_GT(count, 0u);
  const VisibleVoxels found = visibleWithin(scene, {glm::ivec3(0), lookDims}, 1);
  EXPECT_EQ(found.voxels, count);
  EXPECT_EQ(found.lower, lower);
  EXPECT_EQ(found.upper, upper);
}

TEST(LabelLooks, stepsFollowTheFinestLookOfABlockAndSkipWhatNoneShows) {
  Scene scene = labelledScene(5, {1.0, 1.0, 1.0, 1.0});
  scene.transferFunction = bandAt(-50.0); // nothing
  scene.keep = withLooks(scene.keep, {{1, bandAt(10.0)}});
  const BlockFacts facts = blockFacts(*scene.volume);
  const BlockSteps steps = blockSteps(scene, facts);
  const LabelLooks looks = labelLooks(scene);
  int empty = 0, shown = 0;
  for (int z = 0; z < lookDims.z; ++z)
    for (int y = 0; y < lookDims.y; ++y)
      for (int x = 0; x < lookDims.x; ++x) {
        const glm::ivec3 block = glm::min(glm::ivec3(x, y, z) / factCells, steps.blocks - 1);
        const bool isEmpty = steps.rungs[voxelOffset(steps.blocks, block.x, block.y, block.z)].isEmpty;
        const std::size_t voxel = voxelOffset(lookDims, x, y, z);
        const double value = visitVoxels(
            *scene.volume, [voxel](const auto& stored) { return static_cast<double>(stored[voxel]); });
        const bool shows = classify(functionAt(looks, scene.keep, voxel), value).opacity > 0.0;
        ASSERT_FALSE(isEmpty && shows);
        empty += isEmpty ? 1 : 0;
        shown += shows ? 1 : 0;
      }
  EXPECT_GT(empty, 0);
  EXPECT_GT(shown, 0);
}

TEST(LabelLooks, aCoarserRegionKeepsThem) {
  Scene scene = labelledScene(8, {1.0, 1.0, 1.0, 1.0});
  const Region region = withLooks(scene.keep, {{1, bandAt(10.0)}});
  const Region coarse = reduced(region, glm::ivec3(2));
  EXPECT_EQ(coarse.looks, region.looks);
  EXPECT_EQ(coarse.lookOf, region.lookOf);
}

TEST(ShownColors, areThoseOfEachLabelWhateverChanged) {
  Scene scene = labelledScene(3, {1.0, 1.0, 1.0});
  const auto isRight = [](const ShownColors& colors, const Scene& shown) {
    for (std::size_t place = 0; place < 3; ++place)
      if (colors.of(place) != shownColor(*shown.volume, shown.keep, place))
        return false;
    return true;
  };
  // From 2 on blue comes in, so that values decide about the colour.
  const TransferFunction look{1.0, {{0.0, {1, 0, 0}, 0.5}, {2.0, {1, 0, 0}, 0.5}, {9.0, {0, 0, 1}, 0.5}}};
  ShownColors colors;
  colors.follow(scene.volume, scene.keep);
  EXPECT_TRUE(isRight(colors, scene)) << "of the file";
  scene.keep = withLooks(scene.keep, {{1, look}});
  colors.follow(scene.volume, scene.keep);
  EXPECT_TRUE(isRight(colors, scene));
  const glm::dvec3 first = colors.of(1);
  EXPECT_GT(first.r, 0.0);
  EXPECT_GT(first.b, 0.0);
  scene.keep = withLookOf(scene.keep, 2, inOneColor(look, {0, 1, 0}));
  scene.keep = withLookOf(scene.keep, 1, inOneColor(look, {1, 1, 0}));
  colors.follow(scene.volume, scene.keep);
  EXPECT_TRUE(isRight(colors, scene));
  EXPECT_EQ(colors.of(1), glm::dvec3(1, 1, 0));
  // Other voxels by the same curve: of other labels, and of another volume.
  scene.keep = withLooks(scene.keep, {{1, look}});
  colors.follow(scene.volume, scene.keep);
  ASSERT_EQ(colors.of(1), first);
  Scene other = labelledScene(4, {1.0, 1.0, 1.0});
  other.keep = withLooks(other.keep, {{1, look}});
  colors.follow(scene.volume, other.keep);
  EXPECT_NE(colors.of(1), first);
  const glm::dvec3 second = colors.of(1);
  colors.follow(other.volume, other.keep);
  EXPECT_TRUE(isRight(colors, other));
  EXPECT_NE(colors.of(1), second);
}

TEST(ShownColors, holdNoVolumeOfWhichNoneIsAsked) {
  Scene scene = labelledScene(3, {1.0, 1.0, 1.0});
  const std::weak_ptr<const Volume> volume = scene.volume;
  ShownColors colors;
  colors.follow(scene.volume, withLooks(scene.keep, {{1, bandAt(3.0)}}));
  colors.follow(scene.volume, scene.keep);
  scene.volume.reset();
  EXPECT_TRUE(volume.expired());
  EXPECT_EQ(colors.of(1), glm::dvec3(1.0));
}

} // namespace
} // namespace limn
