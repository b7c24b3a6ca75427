// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/GreyWindows.h"

#include "PlaneVolumes.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

TEST(GreyWindows, beginWithSoftTissueInHounsfieldUnits) {
  VolumeInfo info;
  info.unit = "HU";
  info.modality = "CT";
  const Volume ct(test::plainGrid({2, 1, 1}), std::vector<std::int16_t>{-1000, 1000}, {}, std::nullopt, info);
  EXPECT_EQ(firstWindow(ct, histogramOf(ct)), (GreyWindow{40.0, 400.0}));
}

TEST(GreyWindows, leaveOutTheRarestOfOtherData) {
  // 0..999 once each and one voxel of 60000: 99.5 % of 1001 voxels lie below 996.
  const Volume mr = test::volumeOf(test::plainGrid({1001, 1, 1}), [](const glm::ivec3& voxel) {
    return voxel.x < 1000 ? voxel.x : 60000.0;
  });
  const Histogram histogram = histogramOf(mr);
  const GreyWindow window = firstWindow(mr, histogram);
  EXPECT_NEAR(window.centre + window.width / 2, 996.0, binWidth(histogram));
  EXPECT_GE(window.centre - window.width / 2, -binWidth(histogram));
}

TEST(GreyWindows, ofConstantAndTwoValuedVolumesShowThem) {
  const Volume constant = test::volumeOf(test::plainGrid({3, 3, 3}), [](const glm::ivec3&) { return 7.0; });
  EXPECT_EQ(firstWindow(constant, histogramOf(constant)), (GreyWindow{7.0, 1.0}));
  const Volume binary = test::volumeOf(test::plainGrid({10, 10, 10}),
                                       [](const glm::ivec3& voxel) { return voxel == glm::ivec3(5); });
  const GreyWindow window = firstWindow(binary, histogramOf(binary));
  EXPECT_NEAR(window.centre, 0.5, 0.01) << "one voxel in a thousand counts where there is nothing else";
  EXPECT_NEAR(window.width, 1.0, 0.01);
}

TEST(GreyWindows, widenToTheRightAndRiseUpwards) {
  const ValueRange range{-1000.0, 3000.0};
  const GreyWindow start{40.0, 400.0};
  EXPECT_EQ(windowDragged(start, range, 0.0, 0.0), start);
  EXPECT_DOUBLE_EQ(windowDragged(start, range, 256.0, 0.0).width, 400.0 * std::exp(1.0));
  EXPECT_DOUBLE_EQ(windowDragged(start, range, 0.0, 64.0).centre, 140.0);
  EXPECT_DOUBLE_EQ(windowDragged(start, range, -1e9, 0.0).width, 4e-3) << "a millionth of the range";
  EXPECT_EQ(rounded({-53.84, 467.63}), (GreyWindow{-54.0, 468.0}));
  EXPECT_DOUBLE_EQ(rounded({1.23456, 4e-3}).centre, 1.23456) << "of a narrow window nothing is lost";
  EXPECT_DOUBLE_EQ(rounded({1.23456, 0.8}).centre, 1.23);
  EXPECT_GT(withWidth(start, {5.0, 5.0}, -3.0).width, 0.0);
}

} // namespace
} // namespace limn
