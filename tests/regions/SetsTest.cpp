// SPDX-License-Identifier: GPL-3.0-or-later
#include "Sets.h"

#include "regions/BitGrid.h"
#include "regions/Body.h"
#include "regions/Flood.h"
#include "scene/basics/Error.h"

#include <gtest/gtest.h>

// Sets of voxels, 64 at a time, against the same done one voxel at a time. Rows of 1, 63, 64, 65 and 130
// voxels end before, at and behind the end of a word.
namespace limn {
namespace {

using test::forEachVoxel;
using test::randomSet;
using test::setOf;

const std::vector<glm::ivec3> grids{{1, 1, 1}, {63, 5, 4}, {64, 4, 5}, {65, 6, 1}, {130, 3, 6}};

bool isInEllipsoid(const glm::ivec3& offset, const glm::dvec3& radii) {
  double sum = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    if (offset[axis] != 0)
      sum += std::pow(offset[axis] / radii[axis], 2.0);
  return sum <= 1.0 + 1e-9;
}

BitGrid dilatedOneByOne(const BitGrid& set, const glm::dvec3& radii) {
  const glm::ivec3 reach(glm::ceil(radii));
  return setOf(set.dims(), [&](const glm::ivec3& voxel) {
    bool isNear = false;
    forEachVoxel(2 * reach + 1, [&](const glm::ivec3& corner) {
      const glm::ivec3 offset = corner - reach;
      isNear |= isInEllipsoid(offset, radii) && test::isInside(set.dims(), voxel + offset) &&
                set.at(voxel + offset);
    });
    return isNear;
  });
}

TEST(BitGrid, hasTheVoxelsOfItsGridAndNoOthers) {
  for (const glm::ivec3& dims : grids) {
    const BitGrid set = randomSet(dims, 0.4, 1);
    BitGrid both = set;
    both |= set.complement();
    EXPECT_EQ(both.count(), static_cast<std::size_t>(dims.x) * dims.y * dims.z);
    both -= set;
    EXPECT_EQ(both, set.complement());
    both &= set;
    EXPECT_EQ(both.count(), 0u);
  }
}

TEST(Morphology, dilatesAsOneVoxelAtATimeDoes) {
  for (const glm::ivec3& dims : grids)
    for (const glm::dvec3& radii : {glm::dvec3(1), glm::dvec3(2.09, 2.09, 1.33), glm::dvec3(3, 1, 2)}) {
      const BitGrid set = randomSet(dims, 0.02, 2);
      EXPECT_EQ(dilated(set, radii, {}), dilatedOneByOne(set, radii)) << dims.x << " " << radii.x;
    }
}

TEST(Morphology, aLargeBallIsRoundToWithinAVoxel) {
  // 20 voxels are put together from four balls of 5.
  const glm::ivec3 dims(47), middle(23);
  BitGrid point(dims);
  point.set(middle);
  const BitGrid ball = dilated(point, glm::dvec3(20.0), {});
  forEachVoxel(dims, [&](const glm::ivec3& voxel) {
    const double distance = glm::length(glm::dvec3(voxel - middle));
    if (distance <= 18.0 || distance > 20.0) {
      EXPECT_EQ(ball.at(voxel), distance <= 18.0) << distance;
    }
  });
}

TEST(Morphology, erodesFromInsideTheGridOnly) {
  for (const glm::ivec3& dims : grids) {
    const BitGrid all = BitGrid(dims).complement();
    EXPECT_EQ(eroded(all, glm::dvec3(2), {}), all) << "the border is no edge";
    BitGrid holed = all;
    BitGrid hole(dims);
    hole.set(dims / 2);
    holed -= hole;
    EXPECT_EQ(eroded(holed, glm::dvec3(2), {}), dilatedOneByOne(hole, glm::dvec3(2)).complement());
  }
}

TEST(Morphology, openingTakesTheThinAndClosingFillsTheNarrow) {
  const glm::ivec3 dims(70, 20, 20);
  const auto block = [](const glm::ivec3& v) {
    return v.x >= 20 && v.x < 40 && v.y >= 5 && v.y < 15 && v.z >= 5 && v.z < 15;
  };
  const BitGrid withSheet = setOf(dims, [&](const glm::ivec3& v) { return block(v) || v.y == 9; });
  const BitGrid bulky = opened(withSheet, glm::dvec3(1), {});
  EXPECT_FALSE(bulky.at({5, 9, 10})) << "a sheet of one voxel is thinner than a ball of three";
  EXPECT_TRUE(bulky.at({30, 5, 10})) << "the middle of a face stays";
  const BitGrid slit = setOf(dims, [&](const glm::ivec3& v) { return block(v) && v.x != 30; });
  EXPECT_TRUE(closed(slit, glm::dvec3(1), {}).at({30, 10, 10}));
}

TEST(Components, areTheSameAsOneVoxelAtATimeFindsThem) {
  for (const glm::ivec3& dims : grids)
    for (const double share : {0.05, 0.15, 0.9}) {
      const BitGrid set = randomSet(dims, share, 3);
      EXPECT_EQ(largestComponent(set, {}).count(), test::largestPartOf(set).count());
    }
}

TEST(Components, cornersConnect) {
  // Two voxels over a corner, one apart by a voxel.
  BitGrid set({70, 4, 4});
  for (const glm::ivec3& voxel : {glm::ivec3(63, 1, 1), {64, 2, 2}, {66, 2, 2}})
    set.set(voxel);
  const BitGrid largest = largestComponent(set, {});
  EXPECT_EQ(largest.count(), 2u);
  EXPECT_TRUE(largest.at({64, 2, 2}));
  EXPECT_EQ(largestComponent(BitGrid({3, 3, 3}), {}).count(), 0u);
}

TEST(Flood, growsAsOneVoxelAtATimeDoes) {
  for (const glm::ivec3& dims : grids) {
    const BitGrid open = randomSet(dims, 0.12, 5);
    BitGrid seed(dims);
    seed.set(dims / 2);
    BitGrid allowed = open;
    allowed |= seed;
    EXPECT_EQ(grownWithin(seed, open, {}), test::connectedWith(allowed, dims / 2));
  }
}

TEST(Flood, windingWaysAreFollowedToTheirEnd) {
  // One way that goes to and fro: every second row is open, and a gap joins it to the next at alternate ends.
  const glm::ivec3 dims(100, 41, 1);
  const BitGrid way =
      setOf(dims, [](const glm::ivec3& v) { return v.y % 2 == 0 || v.x == (v.y % 4 == 1 ? 99 : 0); });
  BitGrid start(dims);
  start.set({0, 0, 0});
  EXPECT_EQ(grownWithin(start, way, {}), way);
}

TEST(Flood, fillsWhatCannotBeLeftWithinSomeSlice) {
  // A tube along one axis, open at both ends: its inside is a hole of the slices across that axis alone.
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 dims(70, 12, 12);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto ring = [&](const glm::ivec3& voxel) {
      return std::max(std::abs(voxel[u] - 5), std::abs(voxel[v] - 5));
    };
    const BitGrid tube = setOf(dims, [&](const glm::ivec3& voxel) { return ring(voxel) == 3; });
    EXPECT_EQ(withHolesFilled(tube, {}),
              setOf(dims, [&](const glm::ivec3& voxel) { return ring(voxel) <= 3; }))
        << axis;
  }
}

TEST(Flood, leavesWhatTheBorderReachesAndLeaksOverNoCorner) {
  const glm::ivec3 dims(66, 9, 1);
  // A ring of voxels that touch at corners alone: only edges lead out, so that its middle is a hole.
  const auto diamond = [](const glm::ivec3& v) { return std::abs(v.x - 62) + std::abs(v.y - 4); };
  const BitGrid ring = setOf(dims, [&](const glm::ivec3& v) { return diamond(v) == 3; });
  EXPECT_EQ(withHolesFilled(ring, {}), setOf(dims, [&](const glm::ivec3& v) { return diamond(v) <= 3; }));
  const BitGrid open = setOf(dims, [&](const glm::ivec3& v) { return diamond(v) == 3 && v.x != 65; });
  EXPECT_EQ(withHolesFilled(open, {}), open);
}

TEST(Contact, countsTheFacesBetweenSets) {
  // A block of 4×3×2 voxels has 2·(12 + 8 + 6) = 52 faces; across the middle of x it has 3·2 = 6.
  const glm::ivec3 dims(70, 8, 8);
  const auto inBlock = [](const glm::ivec3& v) {
    return v.x >= 62 && v.x < 66 && v.y >= 2 && v.y < 5 && v.z >= 2 && v.z < 4;
  };
  const BitGrid block = setOf(dims, inBlock);
  EXPECT_EQ(sharedFaces(block, block.complement()), 52u);
  const BitGrid left = setOf(dims, [&](const glm::ivec3& v) { return inBlock(v) && v.x < 64; });
  BitGrid right = block;
  right -= left;
  EXPECT_EQ(sharedFaces(left, right), 6u);
  EXPECT_EQ(sharedFaces(right, left), 6u);
}

TEST(Sets, areLeftWhenWorkIsCancelled) {
  const BitGrid set = randomSet({64, 64, 64}, 0.3, 6);
  const Effort cancelled{2, [] { return true; }, {}};
  EXPECT_THROW(dilated(set, glm::dvec3(2), cancelled), Cancelled);
  EXPECT_THROW(largestComponent(set, cancelled), Cancelled);
  EXPECT_THROW(grownWithin(set, set, cancelled), Cancelled);
  EXPECT_THROW(withHolesFilled(set, cancelled), Cancelled);
}

} // namespace
} // namespace limn
