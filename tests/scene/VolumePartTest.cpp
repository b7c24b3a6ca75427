// SPDX-License-Identifier: GPL-3.0-or-later
// What is found of parts of a volume and joined is what is found of the whole, to the bit.
#include "scene/volume/VolumePart.h"

#include "scene/framing/KeptVoxels.h"
#include "scene/framing/VisibleVoxels.h"
#include "scene/light/Gradient.h"
#include "scene/light/ModulusSearch.h"

#include <gtest/gtest.h>

#include <random>

namespace limn {
namespace {

using Random = std::mt19937;

int within(Random& random, int lowest, int highest) {
  return std::uniform_int_distribution<int>(lowest, highest)(random);
}

Grid slantedGrid(const glm::ivec3& dims) {
  Grid grid;
  grid.dims = dims;
  grid.spacingMm = {0.4, 0.7, 1.1};
  return grid;
}

// Steps, a slope and noise; of floats some that are no numbers.
template <class T>
std::vector<T> voxelsOf(const glm::ivec3& dims, Random& random) {
  std::vector<T> voxels;
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j)
      for (int i = 0; i < dims.x; ++i) {
        const int value = (i / 7 % 2) * 60 + (j + k) % 40 + within(random, 0, 20);
        voxels.push_back(static_cast<T>(value));
        if constexpr (std::is_floating_point_v<T>)
          if (within(random, 0, 99) == 0)
            voxels.back() = std::numeric_limits<T>::quiet_NaN();
      }
  return voxels;
}

void divide(const VoxelBox& box, int count, Random& random, std::vector<VoxelBox>& parts) {
  if (count == 1) {
    parts.push_back(box);
    return;
  }
  const int axis = within(random, 0, 2);
  const int plane = within(random, box.lower[axis], box.upper[axis]); // a part may be empty
  VoxelBox below = box, above = box;
  below.upper[axis] = above.lower[axis] = plane;
  divide(below, count / 2, random, parts);
  divide(above, count - count / 2, random, parts);
}

// What each of several processes holds, and all of it in one.
struct Divided {
  std::shared_ptr<const Volume> whole;
  std::vector<std::shared_ptr<const Volume>> parts;
  VoxelFacts facts;
};

// Parts in a random order and grouping.
template <class Part>
Part joinedAnyhow(std::vector<Part> parts, Random& random) {
  std::shuffle(parts.begin(), parts.end(), random);
  while (parts.size() > 1) {
    const auto at = static_cast<std::size_t>(within(random, 0, static_cast<int>(parts.size()) - 2));
    parts[at] = joined(parts[at], parts[at + 1]);
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(at) + 1);
  }
  return parts.front();
}

template <class T>
Divided divided(const glm::ivec3& dims, const Rescale& rescale, int count, Random& random,
                const std::optional<PaddingRange>& padding = {}) {
  const Grid grid = slantedGrid(dims);
  const VoxelArray all = StoredVoxels<T>(voxelsOf<T>(dims, random));
  std::vector<VoxelBox> owns;
  divide(allVoxels(grid), count, random, owns);
  std::vector<VoxelFacts> facts;
  std::vector<std::pair<std::shared_ptr<VolumePart>, VoxelArray>> cuts;
  for (const VoxelBox& own : owns) {
    auto part = std::make_shared<VolumePart>();
    part->own = own;
    part->padding = padding;
    // One beyond on each side at least, as gradients need; an empty part holds something, too.
    const glm::ivec3 more(within(random, 1, 4));
    part->box.lower = glm::clamp(own.lower - more, glm::ivec3(0), dims - 1);
    part->box.upper = glm::min(own.upper + more, dims);
    cuts.emplace_back(part, cutOut(all, dims, part->box));
    facts.push_back(factsOf(cuts.back().second, part->box, own, {}, padding));
  }
  Divided result;
  result.facts = joinedAnyhow(facts, random);
  EXPECT_EQ(result.facts, factsOf(all, allVoxels(grid), allVoxels(grid), {}, padding));
  for (auto& [part, cut] : cuts)
    result.parts.push_back(
        std::make_shared<const Volume>(grid, cut, rescale, VolumeInfo{}, result.facts, part));
  result.whole = std::make_shared<const Volume>(grid, all, rescale, padding, VolumeInfo{});
  return result;
}

// What `find(part, own)` finds of each, joined.
template <class Part, class Find>
Part ofAllParts(const Divided& divided, Random& random, const Find& find) {
  std::vector<Part> found;
  for (const auto& part : divided.parts)
    found.push_back(find(*part, part->part()->own));
  return joinedAnyhow(std::move(found), random);
}

FoundModuli moduliOfParts(const Divided& divided, std::optional<double> percent, Random& random) {
  return findModuliBy(
      {[&] {
         return ofAllParts<ModulusSample>(divided, random, [](const Volume& part, const VoxelBox& own) {
           return sampledModuli(part, own);
         });
       },
       [&](const std::optional<ModulusWindow>& window, double known) {
         return ofAllParts<ModulusCounts>(divided, random, [&](const Volume& part, const VoxelBox& own) {
           return countedModuli(part, own, window, known);
         });
       }},
      *divided.parts.front(), percent);
}

// Where values above one show: of many levels, to the one that none reaches.
void expectSameVisible(const Divided& divided, Random& random) {
  Scene scene;
  scene.volume = divided.whole;
  scene.crop = {{0.1, 0.0, 0.2}, {0.9, 1.0, 0.8}};
  const VoxelBox left = croppedVoxels(divided.whole->grid(), scene.crop);
  const ValueRange range = divided.whole->range();
  for (const double share : {0.0, 0.5, 0.9, 0.99, 1.1}) {
    const double level = glm::mix(range.lowest, range.highest, share);
    scene.transferFunction.points = {{level, glm::dvec3(1.0), 0.0}, {level + 0.1, glm::dvec3(1.0), 1.0}};
    scene.volume = divided.whole;
    for (const int unit : {1, 3}) {
      const VisibleVoxels expected = visibleWithin(scene, left, unit);
      const VisibleVoxels found =
          ofAllParts<VisibleVoxels>(divided, random, [&](const Volume& part, const VoxelBox& own) {
            scene.volume = std::shared_ptr<const Volume>(std::shared_ptr<const void>(), &part);
            return visibleWithin(scene, intersection(left, own), unit);
          });
      EXPECT_EQ(found, expected);
      scene.volume = divided.whole;
    }
  }
}

void expectSameFacts(const Divided& divided, Random& random) {
  const Volume& whole = *divided.whole;
  for (const auto& part : divided.parts) {
    EXPECT_EQ(part->range(), whole.range());
    EXPECT_EQ(part->invalidVoxels(), whole.invalidVoxels());
    EXPECT_EQ(part->voxelCount(), whole.voxelCount());
    EXPECT_EQ(part->storedCounts().first, whole.storedCounts().first);
    EXPECT_EQ(part->storedCounts().counts, whole.storedCounts().counts);
  }
  for (const int bins : {1, 64, 1024}) {
    const BinCounts counts = ofAllParts<BinCounts>(
        divided, random, [&](const Volume& part, const VoxelBox& own) { return countsIn(part, own, bins); });
    EXPECT_EQ(counts.counts, histogramOf(whole, bins).counts);
  }
  const LatticeModuli lattice = ofAllParts<LatticeModuli>(
      divided, random, [](const Volume& part, const VoxelBox& own) { return latticeModuli(part, own); });
  EXPECT_EQ(steepness(*divided.parts.front(), lattice), steepness(whole));
  for (const std::optional<double> percent :
       {std::optional<double>(), std::optional(99.5), std::optional(37.0), std::optional(100.0)})
    EXPECT_EQ(moduliOfParts(divided, percent, random), findModuli(whole, percent)) << percent.value_or(0.0);
  expectSameVisible(divided, random);
}

TEST(VolumePart, partsOfAnyVolumeTellWhatTheWholeTells) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const glm::ivec3 dims(within(random, 1, 70), within(random, 1, 40), within(random, 2, 30));
    const int count = within(random, 1, 7);
    const Rescale rescale{seed % 3 == 0 ? -0.5 : 2.0, -100.0};
    expectSameFacts(divided<std::uint8_t>(dims, rescale, count, random), random);
    expectSameFacts(divided<std::int16_t>(dims, rescale, count, random), random);
    expectSameFacts(divided<std::int32_t>(dims, rescale, count, random), random);
    expectSameFacts(divided<float>(dims, rescale, count, random), random);
    expectSameFacts(divided<double>(dims, rescale, count, random), random);
  }
}

// Declared padding is invalid as NaN is, in types that are counted and those that are not.
TEST(VolumePart, partsLeaveOutPaddingAsTheWholeDoes) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const glm::ivec3 dims(within(random, 20, 70), within(random, 10, 40), within(random, 2, 30));
    const Rescale rescale{seed % 2 == 0 ? -0.5 : 2.0, -100.0};
    const PaddingRange padding{20.0, 37.0};
    const Divided bytes = divided<std::uint8_t>(dims, rescale, 3, random, padding);
    EXPECT_GT(bytes.whole->invalidVoxels(), 0u);
    expectSameFacts(bytes, random);
    expectSameFacts(divided<std::int16_t>(dims, rescale, 4, random, padding), random);
    expectSameFacts(divided<std::int32_t>(dims, rescale, 5, random, padding), random);
    expectSameFacts(divided<float>(dims, rescale, 2, random, padding), random);
  }
}

// So many voxels that a sample tells where a percentile likely is.
TEST(VolumePart, partsOfALargeVolumeDo) {
  Random random(99);
  expectSameFacts(divided<std::int16_t>({131, 90, 67}, {}, 5, random), random);
  expectSameFacts(divided<float>({131, 90, 67}, {}, 3, random), random);
}

} // namespace
} // namespace limn
