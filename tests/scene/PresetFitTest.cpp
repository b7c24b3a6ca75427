// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/presets/PresetFit.h"
#include "scene/volume/Phantom.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

Volume twoClasses() {
  Grid grid;
  grid.dims = {10, 10, 10};
  std::vector<float> voxels(1000, 5.0f);
  for (int i = 0; i < 200; ++i)
    voxels[static_cast<std::size_t>(i)] = 95.0f;
  voxels[999] = 0.0f;
  voxels[998] = 100.0f;
  return Volume(grid, voxels, {}, {}, {});
}

Preset spanning(double first, double last, const std::string& modality) {
  return {.name = "p",
          .modality = modality,
          .note = "",
          .transferFunction = {1.0, {{first, glm::dvec3(1), 0.0}, {last, glm::dvec3(1), 1.0}}},
          .gradientOpacity = std::nullopt,
          .shading = std::nullopt,
          .projection = std::nullopt,
          .isovalue = std::nullopt};
}

TEST(PresetFit, quantileIsTheValueWithThatShareBelow) {
  const Histogram histogram = histogramOf(twoClasses(), 100);
  EXPECT_NEAR(quantile(histogram, 0.5), 5.0, 1.0);
  EXPECT_NEAR(quantile(histogram, 0.9), 95.0, 1.0);
}

TEST(PresetFit, automaticRampIsTransparentForTheBackgroundAndShowsTheObject) {
  const TransferFunction ramp = automaticRamp(histogramOf(twoClasses(), 100));
  EXPECT_EQ(classify(ramp, 5.0).opacity, 0.0);
  EXPECT_GT(classify(ramp, 95.0).opacity, 0.3);
}

TEST(PresetFit, stretchesMrPresetsAndLeavesCtPresetsWhereHounsfieldPutThem) {
  const Preset mr = fittedTo(spanning(0, 1000, "MR"), histogramOf(twoClasses()));
  EXPECT_NEAR(mr.transferFunction.points.front().value, 5.0, 0.1);
  EXPECT_NEAR(mr.transferFunction.points.back().value, 95.0, 0.1);
  EXPECT_EQ(fittedTo(spanning(0, 1000, "CT"), histogramOf(twoClasses())), spanning(0, 1000, "CT"));
}

TEST(PresetFit, recognisesHounsfieldUnitsByNameOrRange) {
  EXPECT_TRUE(looksLikeHounsfield(*phantomVolume({.spacingMm = 16.0})));
  EXPECT_FALSE(looksLikeHounsfield(twoClasses()));
}

TEST(PresetFit, aConstantVolumeStillGetsAFunctionInOrder) {
  Grid grid;
  grid.dims = {2, 2, 2};
  const Volume constant(grid, std::vector<float>(8, 3.0f), {}, {}, {});
  const TransferFunction function = bestFitting({}, constant).transferFunction;
  EXPECT_EQ(normalised(function), function);
}

} // namespace
} // namespace limn
