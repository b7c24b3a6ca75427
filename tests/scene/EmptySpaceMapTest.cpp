// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/EmptySpace.h"
#include "support/JudgedTime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>

namespace limn {
namespace {

glm::ivec3 placeOf(std::size_t block, const glm::ivec3& blocks) {
  const auto n = static_cast<int>(block);
  return {n % blocks.x, n / blocks.x % blocks.y, n / blocks.x / blocks.y};
}

std::size_t countOf(const glm::ivec3& blocks) {
  return static_cast<std::size_t>(blocks.x) * blocks.y * blocks.z;
}

// The definition, one pair of blocks after the other.
BlockDistances distancesByPairs(const glm::ivec3& blocks, const BlockDistances& from) {
  BlockDistances distances(from.size(), farthestBlock);
  for (std::size_t near = 0; near < from.size(); ++near)
    for (std::size_t i = 0; from[near] == 0 && i < from.size(); ++i) {
      const glm::ivec3 way = glm::abs(placeOf(i, blocks) - placeOf(near, blocks));
      distances[i] = static_cast<std::uint8_t>(std::min<int>(distances[i], std::max({way.x, way.y, way.z})));
    }
  return distances;
}

constexpr glm::ivec3 shapes[] = {{1, 1, 1},    {1, 7, 1},  {290, 1, 1}, {1, 290, 2}, {3, 2, 290},
                                 {17, 16, 15}, {40, 9, 5}, {5, 33, 12}, {129, 4, 3}};

TEST(EmptySpaceMap, distancesAreThoseOfTheNearestBlock) {
  std::mt19937 random(7);
  for (const glm::ivec3& blocks : shapes)
    for (const int visible : {0, 1, 2, 40}) {
      BlockDistances distances(countOf(blocks), farthestBlock);
      for (int i = 0; i < visible; ++i)
        distances[random() % distances.size()] = 0;
      const BlockDistances expected = distancesByPairs(blocks, distances);
      for (const int threads : {1, 3}) {
        BlockDistances spread = distances;
        spreadDistances(blocks, spread, {threads, {}, {}});
        EXPECT_EQ(spread, expected) << blocks.x << " x " << blocks.y << " x " << blocks.z << ", " << visible;
      }
    }
}

// Ranges as volumes have them: most of air, some of one tissue, some across an edge.
BlockRanges randomRanges(const glm::ivec3& blocks, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> any(0.0f, 1.0f);
  BlockRanges ranges(blocks);
  for (std::size_t i = 0; i < countOf(blocks); ++i) {
    const glm::ivec3 at = placeOf(i, blocks);
    const bool isInside = at.x + at.y > (blocks.x + blocks.y) / 2;
    const float lowest = isInside ? 0.25f + 0.5f * any(random) : 0.01f * any(random);
    ranges.set(at, {lowest, lowest + (random() % 8 == 0 ? 0.2f : 0.01f) * any(random)});
  }
  ranges.finish();
  return ranges;
}

// A sample of a block may fall into any bin from that of its lowest to that of its highest scalar, and by
// rounding into those beside the two where it lies at their edge.
bool mayShow(const glm::vec2& range, const Visibility& visibility) {
  if (visibility.isovalue && *visibility.isovalue <= range.y + 1e-5f)
    return true;
  if (!visibility.function)
    return false;
  const glm::vec3 domain = visibility.function->domain;
  const auto binOf = [&](float scalar, float margin) {
    return std::clamp(std::floor((scalar - domain.x) * domain.y + margin), 0.0f, domain.z);
  };
  for (float bin = binOf(range.x, -0.01f); bin <= binOf(range.y, 0.01f); bin += 1.0f)
    if (visibility.function->occupancy[static_cast<std::size_t>(bin)].x > 0.0f)
      return true;
  return false;
}

TransferFunction spikes(int count) {
  TransferFunction function;
  for (int i = 0; i < count; ++i) {
    const double at = (i + 0.5) / count;
    for (const auto& [side, opacity] : {std::pair(-0.002, 0.0), {-0.001, 0.5}, {0.001, 0.5}, {0.002, 0.0}})
      function.points.push_back({at + side, glm::dvec3(1.0), opacity});
  }
  return function;
}

TEST(EmptySpaceMap, holdsWhatEveryBlockByItselfSays) {
  std::vector<PiecewiseTable> tables;
  for (const TransferFunction& function :
       {TransferFunction{}, spikes(1), spikes(3), spikes(60),
        TransferFunction{1.0, {{0.3, glm::dvec3(1.0), 0.0}, {0.6, glm::dvec3(1.0), 1.0}}},
        TransferFunction{1.0, {{0.2, glm::dvec3(1.0), 1.0}, {0.4, glm::dvec3(1.0), 0.0}}},
        TransferFunction{1.0, {{0.5, glm::dvec3(1.0), 0.4}}}})
    tables.push_back(tableOf(function, {0.0, 1.0}));
  std::vector<Visibility> all{{}};
  for (const PiecewiseTable& table : tables)
    for (const std::optional<float> isovalue :
         {std::optional<float>(), std::optional(-0.5f), std::optional(0.31f), std::optional(2.0f)})
      all.push_back({&table, isovalue});
  all.push_back({nullptr, 0.4f});
  for (const glm::ivec3& blocks : {glm::ivec3(1), glm::ivec3(13, 10, 9), glm::ivec3(16, 8, 4)}) {
    const BlockRanges ranges = randomRanges(blocks, 3);
    int partly = 0;
    for (const Visibility& visibility : all) {
      EmptySpaceMap expected;
      for (std::size_t i = 0; i < countOf(blocks); ++i) {
        const glm::ivec3 at = placeOf(i, blocks);
        const bool shows = mayShow(ranges.at(at), visibility);
        expected.distances.push_back(shows ? std::uint8_t{0} : farthestBlock);
        expected.emptyShare += shows ? 0.0 : 1.0 / static_cast<double>(countOf(blocks));
        if (shows && expected.visible == BlockBox{})
          expected.visible = {at, at + 1};
        if (shows)
          expected.visible = {glm::min(expected.visible.lower, at), glm::max(expected.visible.upper, at + 1)};
      }
      partly += expected.emptyShare > 0.1 && expected.emptyShare < 0.9;
      expected.distances = distancesByPairs(blocks, expected.distances);
      EmptySpaceMap map;
      for (const int threads : {1, 4}) {
        mapEmptySpace(ranges, visibility, map, {threads, {}, {}});
        EXPECT_EQ(map.distances, expected.distances);
        EXPECT_EQ(map.visible, expected.visible);
        EXPECT_NEAR(map.emptyShare, expected.emptyShare, 1e-9);
      }
    }
    EXPECT_GT(partly, blocks.x > 1 ? 8 : -1) << "most of them tell blocks apart";
  }
}

// A ball of tissue with a hard core in air, in which no two blocks are alike.
BlockRanges ballOf(const glm::ivec3& blocks) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> noise(0.0f, 0.02f);
  BlockRanges ranges(blocks);
  for (std::size_t i = 0; i < countOf(blocks); ++i) {
    const glm::ivec3 at = placeOf(i, blocks);
    const glm::vec3 fromCentre = (glm::vec3(at) + 0.5f) / glm::vec3(blocks) - 0.5f;
    const float radius = glm::length(fromCentre);
    const float value = radius > 0.4f ? 0.0f : radius > 0.2f ? 0.26f : 0.3f + 0.5f * noise(random) / 0.02f;
    ranges.set(at, {value, value + noise(random)});
  }
  ranges.finish();
  return ranges;
}

TEST(EmptySpaceMap, anEditAt512VoxelsAlongEachAxisIsAnsweredWithinFiveMilliseconds) {
  const BlockRanges ranges = ballOf(glm::ivec3(128));
  EmptySpaceMap map;
  double bestMs = 1e9;
  for (int i = 0; i < 25; ++i) {
    const double from = 0.2 + 0.01 * i;
    const PiecewiseTable table =
        tableOf(TransferFunction{1.0, {{from, glm::dvec3(1.0), 0.0}, {from + 0.1, glm::dvec3(1.0), 1.0}}},
                {0.0, 1.0});
    const auto start = std::chrono::steady_clock::now();
    mapEmptySpace(ranges, {&table, {}}, map);
    const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
    bestMs = std::min(bestMs, ms.count());
    EXPECT_GT(map.emptyShare, 0.2);
    EXPECT_LT(map.emptyShare, 0.999);
  }
  test::judgeMs("the best of 25 edits at 512 voxels along each axis", bestMs, 5.0);
}

} // namespace
} // namespace limn
