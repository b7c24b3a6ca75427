// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/times/CostModel.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

ScaleRow opened(int edge, double cpuMs) {
  ScaleRow row;
  row.edge = edge;
  row.opened.cpuMs = cpuMs;
  row.drawn.program = "limn-cpu";
  return row;
}

double openCpuMs(const ScaleRow& row) {
  return row.opened.cpuMs;
}

// 512³ voxels, 1000 x 1000 pixels, 10⁸ samples in 8 bricks by one core in 0.5 s.
BrickRow measuredBricks() {
  BrickRow row;
  row.edge = 512;
  row.bricks = 8;
  row.size = {1000, 1000};
  row.samples = 1e8;
  row.mostSamples = 2.5e7;
  row.cpuMs = 500.0;
  row.mostKeptMb = 2.0;
  return row;
}

TEST(CostModel, growthIsThePowerOfTheVoxelsBetweenTheLargestTwo) {
  // Eight times the voxels take eight times as long: power 1; twice as long, power 1/3.
  EXPECT_DOUBLE_EQ(growthOf({opened(128, 1.0), opened(256, 8.0)}, "limn-cpu", openCpuMs).value(), 1.0);
  EXPECT_NEAR(
      growthOf({opened(512, 16.0), opened(128, 1.0), opened(256, 8.0)}, "limn-cpu", openCpuMs).value(),
      1.0 / 3.0, 1e-12);
  EXPECT_FALSE(growthOf({opened(128, 1.0)}, "limn-cpu", openCpuMs));
  EXPECT_FALSE(growthOf({opened(128, 1.0), opened(256, 8.0)}, "limn-gl", openCpuMs));
  EXPECT_FALSE(growthOf({opened(128, 0.0), opened(256, 0.0)}, "limn-cpu", openCpuMs))
      << "nothing grows from 0";
}

TEST(CostModel, factsAreThoseOfTheLargestVolumeInTheMostBricks) {
  BrickRow small = measuredBricks();
  small.edge = 128;
  small.samples = 1.0;
  BrickRow whole = measuredBricks();
  whole.bricks = 1;
  whole.mostSamples = whole.samples;
  EXPECT_EQ(imbalanceOf(whole), 1.0);
  const CostFacts facts = costFacts({whole, measuredBricks(), small});
  EXPECT_DOUBLE_EQ(facts.samplesPerCpuSecond, 2e8);
  EXPECT_DOUBLE_EQ(facts.samplesPerPixelEdge, 1e8 / (1e6 * 512));
  EXPECT_DOUBLE_EQ(facts.keptBytesPerVoxel, 2e6 * 8 / (512.0 * 512 * 512));
  EXPECT_DOUBLE_EQ(facts.imbalance, 2.0); // 2.5e7 where the mean is 1.25e7
}

TEST(CostModel, manyNodesShareVoxelsAndSendOnePictureEach) {
  const CostFacts facts{2e8, 0.5, 0.25, 1.5};
  const SupposedNodes supposed{10, 1e9, 1e9, 2};
  const ManyNodes nodes = onManyNodes(facts, supposed, 1e12, {1000, 1000}, 1000);
  EXPECT_DOUBLE_EQ(nodes.voxelsEach, 1e9);
  EXPECT_DOUBLE_EQ(nodes.voxelGbEach, 2.0);
  EXPECT_DOUBLE_EQ(nodes.keptGbEach, 0.25);
  EXPECT_DOUBLE_EQ(nodes.readSeconds, 2.0);
  // 0.5 · 10⁶ pixels · 10⁴ voxels = 5·10⁹ samples; 1.5 · 5·10⁹ / (1000 · 10 · 2·10⁸) s = 3.75 ms.
  EXPECT_NEAR(nodes.marchMs, 3.75, 1e-9);
  EXPECT_DOUBLE_EQ(nodes.messageMb, 16.0);
  EXPECT_DOUBLE_EQ(nodes.movedGb, 15.984);
  // Ten levels of a tree of 1000 leaves, 16 ms each.
  EXPECT_NEAR(nodes.compositeMs, 160.0, 1e-9);
  EXPECT_EQ(onManyNodes(facts, supposed, 1e12, {1000, 1000}, 1).compositeMs, 0.0);
}

TEST(CostModel, moreNodesThanUsefulMakeAPictureLater) {
  const CostFacts facts{2e8, 0.5, 0.25, 1.5};
  const SupposedNodes supposed{10, 1e9, 1e9, 2};
  const glm::ivec2 size(1000, 1000);
  const double best = mostUsefulNodes(facts, supposed, 1e12, size);
  const auto pictureMs = [&](double nodes) {
    const ManyNodes one = onManyNodes(facts, supposed, 1e12, size, nodes);
    return one.marchMs + one.compositeMs;
  };
  EXPECT_GT(best, 1.0);
  EXPECT_GT(pictureMs(best / 2), pictureMs(best));
  EXPECT_GT(pictureMs(2 * best), pictureMs(best));
}

} // namespace
} // namespace limn
