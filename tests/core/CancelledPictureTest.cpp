// SPDX-License-Identifier: GPL-3.0-or-later
// Whoever saves a large picture and thinks better of it waits for moments, whatever is being done: the volume
// read, steps looked for that keep the tolerance, strips drawn and put together.
#include "app/core/drawing/PictureMaker.h"
#include "scene/basics/Error.h"
#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"
#include "support/LongestWait.h"
#include "support/Sanitizers.h"

#include <gtest/gtest.h>

#include <cmath>

namespace limn {
namespace {

TEST(CancelledPicture, of3000SquaredAtOneLevelIsGivenUpWithinMoments) {
  Scene scene = headScene(phantomVolume({.spacingMm = 4.0}), ShadingModel::none);
  scene.quality.toleranceLevels = 1.0;
  constexpr double mostMs = 50.0;
  const auto wait = test::waitOf(mostMs, [&](test::LongestWait& longest) {
    double done = 0.0;
    MakingOptions order;
    order.engine = Engine::cpu;
    order.effort.report = [&](double fraction) { done = fraction; };
    // Once all that is made before and five strips of 128 rows are behind, which those tried before do not
    // have.
    constexpr double enough = 5.0 * 128.0 / 3000.0;
    const auto isEnough = [&] { return std::abs(done - enough) < 1e-9; };
    order.effort.isCancelled = [&] {
      longest.asked();
      return isEnough();
    };
    EXPECT_THROW(makeEach({scene}, {3000, 3000}, order, [](std::size_t, MadePicture) {}), Cancelled);
    longest.asked();
    EXPECT_TRUE(isEnough());
    EXPECT_GT(longest.count(), 1000);
  });
  test::judgeMs("a picture of 3,000² at one level is given up", wait.clockMs(), mostMs);
  std::printf("%.1f ms of the processor at most between two of %d questions\n", wait.cpuMs(), wait.count());
  LIMN_NEEDS_ITS_OWN_TIME;
  EXPECT_LE(wait.cpuMs(), mostMs);
}

} // namespace
} // namespace limn
