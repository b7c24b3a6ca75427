// SPDX-License-Identifier: GPL-3.0-or-later
// Ten million random paths for each number that is known of slabs: minutes.
#include "cpu/paths/SlabPaths.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(PathsAtScale, slabsSendOnWhatAddingDoublingSays) {
  // Chance alone exceeds four standard errors in one of 400 runs of these 36 numbers; the seeds are fixed.
  EXPECT_LT(test::largestSlabZ(10'000'000), 4.0);
}

} // namespace
} // namespace limn
