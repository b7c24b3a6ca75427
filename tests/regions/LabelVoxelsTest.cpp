// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/LabelVoxels.h"

#include <gtest/gtest.h>

#include <limits>

namespace limn {
namespace {

Grid smallGrid() {
  Grid grid;
  grid.dims = {3, 2, 2};
  grid.spacingMm = {0.5, 2.0, 10.0}; // 10 mm³ a voxel
  return grid;
}

LabelMap smallMap() {
  return {{3, 2, 2},
          std::vector<std::uint8_t>{0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 2},
          {{0, "Background", glm::dvec3(0.5)},
           {5, "Four", {1, 0, 0}},
           {7, "One", {0, 1, 0}},
           {9, "None", {0, 0, 1}}}};
}

TEST(LabelVoxels, tellTheSizeAndTheValuesOfEachLabel) {
  // Stored 2, 4, 4, 6 become 20 more: mean 24, squared distances 4, 0, 0, 4 with the mean 2.
  const Volume volume(smallGrid(), std::vector<std::int16_t>{90, 2, 4, 4, 6, 90, 90, 90, 90, 90, 90, -7},
                      Rescale{1.0, 20.0}, std::nullopt, VolumeInfo{});
  const std::vector<LabelFigures> figures = figuresOfLabels(smallMap(), volume);
  ASSERT_EQ(figures.size(), 4u);
  EXPECT_DOUBLE_EQ(figures[1].millilitres, 0.04);
  EXPECT_EQ(figures[1].voxels, 4u);
  EXPECT_DOUBLE_EQ(figures[1].mean, 24.0);
  EXPECT_DOUBLE_EQ(figures[1].deviation, std::sqrt(2.0));
  EXPECT_EQ(figures[1].lowest, 22.0);
  EXPECT_EQ(figures[1].highest, 26.0);
  EXPECT_EQ(figures[2].mean, 13.0);
  EXPECT_EQ(figures[2].deviation, 0.0);
  EXPECT_EQ(figures[3], LabelFigures{}) << "a label of no voxel";
  EXPECT_DOUBLE_EQ(figures[0].millilitres, 0.07);
}

TEST(LabelVoxels, invalidVoxelsCountForTheSizeAlone) {
  const float none = std::numeric_limits<float>::quiet_NaN();
  const Volume volume(smallGrid(), std::vector<float>{9, 2, none, 4, none, 9, 9, 9, 9, 9, 9, none}, Rescale{},
                      std::nullopt, VolumeInfo{});
  const std::vector<LabelFigures> figures = figuresOfLabels(smallMap(), volume);
  EXPECT_DOUBLE_EQ(figures[1].millilitres, 0.04);
  EXPECT_EQ(figures[1].voxels, 2u);
  EXPECT_DOUBLE_EQ(figures[1].mean, 3.0);
  EXPECT_DOUBLE_EQ(figures[1].deviation, 1.0);
  EXPECT_DOUBLE_EQ(figures[2].millilitres, 0.01);
  EXPECT_EQ(figures[2].voxels, 0u);
  EXPECT_EQ(figures[2].mean, 0.0);
}

TEST(LabelVoxels, canBeCancelled) {
  const Volume volume(smallGrid(), std::vector<float>(12, 1.0f), Rescale{}, std::nullopt, VolumeInfo{});
  EXPECT_THROW(figuresOfLabels(smallMap(), volume, {1, [] { return true; }, {}}), Cancelled);
}

} // namespace
} // namespace limn
