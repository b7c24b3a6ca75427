// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/BlockSteps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace limn {
namespace {

// Voxels of any kind, not all of the type's range: some blocks are even.
template <class T>
Volume randomVolume(const glm::ivec3& dims, const glm::dvec3& spacingMm, const Rescale& rescale) {
  std::mt19937 random(5);
  std::vector<T> voxels(static_cast<std::size_t>(dims.x) * dims.y * dims.z);
  for (std::size_t n = 0; n < voxels.size(); ++n)
    voxels[n] = n % 64 < 9 ? T{7} : static_cast<T>(static_cast<std::int64_t>(random()));
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = spacingMm;
  return Volume(grid, std::move(voxels), rescale, std::nullopt, VolumeInfo{});
}

// The definition, voxel after voxel: the voxels on and in the block, the changes between them, and the change
// of the slope at each, which beyond the outermost centres is 0.
FieldFacts factsByVoxels(const Volume& volume, const glm::ivec3& block) {
  const glm::ivec3 dims = volume.grid().dims;
  const glm::dvec3 spacing = volume.grid().spacingMm;
  const glm::ivec3 first = block * factCells;
  const glm::ivec3 last = glm::min(first + factCells, dims - 1);
  const double infinite = std::numeric_limits<double>::infinity();
  FieldFacts facts{{infinite, -infinite}};
  glm::dvec3 steepest(0.0);
  for (int k = first.z; k <= last.z; ++k)
    for (int j = first.y; j <= last.y; ++j)
      for (int i = first.x; i <= last.x; ++i) {
        const glm::ivec3 at(i, j, k);
        const double here = volume.value(at);
        facts.range = {std::min(facts.range.lowest, here), std::max(facts.range.highest, here)};
        glm::dvec3 bent(0.0);
        for (int axis = 0; axis < 3; ++axis) {
          glm::ivec3 next = at, before = at;
          next[axis] = std::min(at[axis] + 1, dims[axis] - 1);
          before[axis] = std::max(at[axis] - 1, 0);
          const double up = volume.value(next) - here, down = here - volume.value(before);
          bent[axis] = (up - down) / (spacing[axis] * spacing[axis]);
          if (at[axis] < last[axis])
            steepest[axis] = std::max(steepest[axis], std::abs(up) / spacing[axis]);
        }
        facts.bendPerMm2 = std::max(facts.bendPerMm2, glm::length(bent));
      }
  facts.steepestPerMm = glm::length(steepest);
  return facts;
}

template <class T>
class BlockFactsOf : public testing::Test {};
using VoxelTypes = testing::Types<std::uint8_t, std::int8_t, std::uint16_t, std::int16_t, std::uint32_t,
                                  std::int32_t, float, double>;
TYPED_TEST_SUITE(BlockFactsOf, VoxelTypes);

// Differences of 8 and 16 bits are exact in float; weighing, squaring and adding three of them rounds by less
// than 1e-6 of the sum.
TYPED_TEST(BlockFactsOf, areThoseOfTheirVoxelsOneByOne) {
  for (const glm::ivec3& dims : {glm::ivec3(1), glm::ivec3(1, 7, 6), glm::ivec3(9, 1, 5),
                                 glm::ivec3(6, 13, 1), glm::ivec3(5), glm::ivec3(18, 11, 10)})
    for (const double scale : {1.0, 1e-6, 1e6}) {
      const Volume volume = randomVolume<TypeParam>(dims, scale * glm::dvec3(0.7, 1.3, 0.9), {-0.5, 11.0});
      const BlockFacts facts = blockFacts(volume, {3, {}, {}});
      EXPECT_EQ(facts.range, volume.range());
      for (int k = 0; k < facts.blocks.z; ++k)
        for (int j = 0; j < facts.blocks.y; ++j)
          for (int i = 0; i < facts.blocks.x; ++i) {
            const FieldFacts& found = facts.facts[voxelOffset(facts.blocks, i, j, k)];
            const FieldFacts expected = factsByVoxels(volume, {i, j, k});
            EXPECT_EQ(found.range, expected.range);
            EXPECT_NEAR(found.steepestPerMm, expected.steepestPerMm, 1e-12 * expected.steepestPerMm);
            EXPECT_NEAR(found.bendPerMm2, expected.bendPerMm2, 1e-6 * expected.bendPerMm2);
          }
    }
}

} // namespace
} // namespace limn
