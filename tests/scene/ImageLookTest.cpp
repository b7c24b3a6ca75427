// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/presets/PresetFit.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

// 1,000 values, equally many of each from `first` on.
Volume imageFrom(float first, float step, const char* unit) {
  Grid grid;
  grid.dims = {50, 20, 1};
  grid.spacingMm = {0.25, 0.25, 5.0};
  std::vector<float> voxels(1000);
  for (std::size_t i = 0; i < voxels.size(); ++i)
    voxels[i] = first + step * static_cast<float>(i);
  VolumeInfo info;
  info.unit = unit;
  return Volume(grid, voxels, {}, {}, info);
}

Preset lookOf(const Volume& image) {
  return imageLook(image, histogramOf(image, 1000));
}

TEST(ImageLook, isUnlitAndOpaqueFromBlackToWhite) {
  const Preset look = lookOf(imageFrom(0.0f, 1.0f, ""));
  ASSERT_TRUE(look.shading);
  EXPECT_EQ(look.shading->model, ShadingModel::none);
  EXPECT_EQ(look.projection, Projection::composite);
  const TransferFunction& curve = look.transferFunction;
  for (const double value : {0.0, 400.0, 999.0})
    EXPECT_EQ(classify(curve, value).opacity, 1.0);
  EXPECT_EQ(classify(curve, 0.0).color, glm::dvec3(0.0));
  EXPECT_EQ(classify(curve, 999.0).color, glm::dvec3(1.0));
  EXPECT_EQ(curve.unitDistanceMm, 0.25) << "opaque within a pixel's width";
}

TEST(ImageLook, leavesTheOutermostHalfPercentOfValuesBlackAndWhite) {
  const TransferFunction curve = lookOf(imageFrom(0.0f, 1.0f, "")).transferFunction;
  // 5 of 1,000 voxels lie below 5, and 5 above 994; a bin holds one value.
  EXPECT_NEAR(curve.points.front().value, 5.0, 1.0);
  EXPECT_NEAR(curve.points.back().value, 994.0, 1.0);
}

TEST(ImageLook, ofHounsfieldUnitsShowsSoftTissueWhereThereIsSome) {
  const TransferFunction tissue = lookOf(imageFrom(-1000.0f, 2.0f, "HU")).transferFunction;
  EXPECT_EQ(tissue.points.front().value, -160.0);
  EXPECT_EQ(tissue.points.back().value, 240.0);
  const TransferFunction metal = lookOf(imageFrom(1000.0f, 2.0f, "HU")).transferFunction;
  EXPECT_NEAR(metal.points.front().value, 1010.0, 2.0);
  EXPECT_NEAR(metal.points.back().value, 2988.0, 2.0);
}

TEST(ImageLook, ofEqualValuesStillAscends) {
  const TransferFunction curve = lookOf(imageFrom(7.0f, 0.0f, "")).transferFunction;
  EXPECT_LT(curve.points.front().value, curve.points.back().value);
}

TEST(ImageLook, isTheFirstLookOfOneSliceWhateverItsModality) {
  EXPECT_EQ(bestFitting({}, imageFrom(-1000.0f, 2.0f, "HU")).name, "Image");
  Grid grid;
  grid.dims = {10, 10, 2};
  EXPECT_NE(bestFitting({}, Volume(grid, std::vector<float>(200, 1.0f), {}, {}, {})).name, "Image");
}

} // namespace
} // namespace limn
