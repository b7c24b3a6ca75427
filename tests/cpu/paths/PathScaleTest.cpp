// SPDX-License-Identifier: GPL-3.0-or-later
// A million random paths for each number that is known of slabs, or, where LIMN_EVERY_PATH is set, ten: a
// quarter of an hour.
#include "cpu/paths/SlabPaths.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace limn {
namespace {

TEST(PathsAtScale, slabsSendOnWhatAddingDoublingSays) {
  // Chance alone exceeds four standard errors in one of 400 runs of these 36 numbers; the seeds are fixed.
  EXPECT_LT(test::largestSlabZ(std::getenv("LIMN_EVERY_PATH") ? 10'000'000 : 1'000'000), 4.0);
}

} // namespace
} // namespace limn
