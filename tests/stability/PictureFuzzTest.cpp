// SPDX-License-Identifier: GPL-3.0-or-later
// 2,000 random scenes (HARD_CASES section 5), in parts so that they run beside each other. Without a card
// all of them are drawn by Mesa's softpipe, which interprets programs, and two parts by llvmpipe, too, which
// takes longer to compile them than to draw so few pixels.
// `limn stability --fuzz N --seed S` draws any others.
#include "stability/PictureFuzz.h"
#include "support/GlTest.h"

#include <cstdlib>
#include <iostream>

namespace limn {
namespace {

constexpr int seedsPerPart = 250;

class Fuzz : public test::GlTest, public ::testing::WithParamInterface<int> {
protected:
  static void expectInvariants(int part);
};

class InterpretedFuzz : public Fuzz {
protected:
  static void SetUpTestSuite() { setenv("GALLIUM_DRIVER", "softpipe", 0); }
};

void print(const FuzzReport& report) {
  std::cout << report.seeds << " seeds, " << report.refused << " volumes refused, "
            << report.referenceCompared << " compared with the reference over " << report.pixelsCompared
            << " pixels (" << report.pixelsUnequal << " of unequal N), worst difference "
            << report.worstDifference << " (seed " << report.worstSeed << "), " << report.slices
            << " drawn as slices, " << report.brickCompared << " in bricks, worst difference "
            << report.worstInBricks << ", " << report.freshlyDrawn << " by a fresh ray caster; slowest "
            << report.slowestSeconds << " s (seed " << report.slowestSeed << ")\n";
}

void Fuzz::expectInvariants(int part) {
  const FuzzReport report = runFuzz(seedsPerPart, static_cast<std::uint64_t>(part) * seedsPerPart);
  print(report);
  EXPECT_EQ(report.seeds, seedsPerPart);
  for (const FuzzFailure& failure : report.failures)
    ADD_FAILURE() << lineOf(failure);
  // The part says something: a third of the seeds is comparable, few volumes hold no valid voxel.
  EXPECT_GE(report.referenceCompared, seedsPerPart / 4);
  EXPECT_LE(report.refused, seedsPerPart / 10);
  EXPECT_GT(report.slices, 0);
  EXPECT_GE(report.brickCompared, seedsPerPart / 2);
  EXPECT_GT(report.freshlyDrawn, 0);
}

TEST_P(Fuzz, everyInvariantHoldsForEverySeed) {
  expectInvariants(GetParam());
}

TEST_P(InterpretedFuzz, everyInvariantHoldsForEverySeed) {
  expectInvariants(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Parts, Fuzz, ::testing::Values(2, 5));
INSTANTIATE_TEST_SUITE_P(Parts, InterpretedFuzz, ::testing::Range(0, 8));

} // namespace
} // namespace limn
