// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/PlanePixels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace limn {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

TEST(PlanePixels, areGreyByTheWindow) {
  // Brain: 40 ± 40. DICOM's LINEAR_EXACT: 0 at 0 HU, 1 at 80 HU, half at 40.
  const GreyWindow brain{40.0, 80.0};
  EXPECT_EQ(greyOf(brain, -1000.0), 0.0);
  EXPECT_EQ(greyOf(brain, 0.0), 0.0);
  EXPECT_EQ(greyOf(brain, 20.0), 0.25);
  EXPECT_EQ(greyOf(brain, 40.0), 0.5);
  EXPECT_EQ(greyOf(brain, 3000.0), 1.0);
  const PlaneImage image{{4, 1}, {nothing, 0.0, 20.0, 80.0}};
  // 0.25 · 255 = 63.75, which is nearest to 64 = 0x40.
  EXPECT_EQ(planePixels(image, brain, std::nullopt),
            (std::vector<std::uint32_t>{0x00000000, 0xff000000, 0xff404040, 0xffffffff}));
}

TEST(PlanePixels, areTintedAsStronglyAsACentimetreOfTheTissueIsOpaque) {
  // Red from 10 on, with an opacity over 1 mm of 1 - 0.5^(1/10): half over 10 mm. At 20 opaque: at most 0.7.
  TransferFunction function;
  const double tenth = 1.0 - std::pow(0.5, 0.1);
  function.points = {{0.0, {1, 0, 0}, 0.0},
                     {10.0, {1, 0, 0}, 0.0},
                     {10.0, {1, 0, 0}, tenth},
                     {15.0, {1, 0, 0}, tenth},
                     {20.0, {1, 0, 0}, 1.0}};
  const PlaneImage image{{5, 1}, {0.0, 5.0, 12.5, 20.0, nothing}};
  const GreyWindow black{1000.0, 1.0};
  // Half of 255 is 127.5 or a little beside it, by the step of the table; 0.7 · 255 = 178.5.
  const std::vector<std::uint32_t> pixels = planePixels(image, black, PlaneTint{function});
  EXPECT_EQ(pixels[0], 0xff000000u);
  EXPECT_EQ(pixels[1], 0xff000000u);
  EXPECT_NEAR(static_cast<double>(pixels[2] >> 16 & 255), 127.5, 1.0);
  EXPECT_NEAR(static_cast<double>(pixels[3] >> 16 & 255), 178.5, 1.0);
  EXPECT_EQ(pixels[4], 0u);
  const PlaneImage weights{{5, 1}, {1.0, 1.0, 0.5, 0.0, nothing}};
  const std::vector<std::uint32_t> kept = planePixels(image, black, PlaneTint{function, &weights});
  EXPECT_NEAR(static_cast<double>(kept[2] >> 16 & 255), 63.75, 1.0) << "half of half";
  EXPECT_EQ(kept[3], 0xff000000u) << "not kept, not tinted";
}

TEST(PlanePixels, ofAConstantOrEmptySliceCanBeTinted) {
  TransferFunction function;
  function.points = {{0.0, {0, 1, 0}, 1.0}};
  const PlaneImage constant{{2, 1}, {5.0, 5.0}};
  for (const std::uint32_t pixel : planePixels(constant, {1000.0, 1.0}, PlaneTint{function}))
    EXPECT_NEAR(static_cast<double>(pixel >> 8 & 255), 178.5, 1.0);
  const PlaneImage empty{{2, 1}, {nothing, nothing}};
  EXPECT_EQ(planePixels(empty, {}, PlaneTint{function}), (std::vector<std::uint32_t>{0, 0}));
}

TEST(PlaneOutline, runsAlongWhatIsNotKept) {
  // Kept are the right three columns; the volume ends before the last row.
  const PlaneImage weights{{5, 3},
                           {0.0, 0.2, 0.5, 1.0, 1.0, //
                            0.0, 0.2, 0.9, 1.0, 1.0, //
                            nothing, nothing, nothing, nothing, nothing}};
  EXPECT_EQ(outlineOf(weights), (std::vector<std::uint8_t>{0, 0, 1, 0, 0, //
                                                           0, 0, 1, 0, 0, //
                                                           0, 0, 0, 0, 0}));
  EXPECT_EQ(outlineOf(weights, 2), (std::vector<std::uint8_t>{0, 0, 1, 1, 0, //
                                                              0, 0, 1, 1, 0, //
                                                              0, 0, 0, 0, 0}));
}

} // namespace
} // namespace limn
