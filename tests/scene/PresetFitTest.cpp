// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/presets/PresetFit.h"
#include "scene/volume/Phantom.h"

#include <gtest/gtest.h>

#include <cmath>

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
          .folder = "",
          .transferFunction = {1.0, {{first, glm::dvec3(1), 0.0}, {last, glm::dvec3(1), 1.0}}},
          .gradientOpacity = std::nullopt,
          .shading = std::nullopt,
          .projection = std::nullopt,
          .isovalue = std::nullopt,
          .landmarks = std::nullopt};
}

TEST(PresetFit, quantileIsTheValueWithThatShareBelow) {
  const Histogram histogram = histogramOf(twoClasses(), 100);
  EXPECT_NEAR(quantile(histogram, 0.5), 5.0, 1.0);
  EXPECT_NEAR(quantile(histogram, 0.9), 95.0, 1.0);
}

TEST(PresetFit, automaticRampIsTransparentForTheBackgroundAndShowsTheObject) {
  const TransferFunction ramp = automaticRamp(histogramOf(twoClasses(), 100), {});
  EXPECT_EQ(classify(ramp, 5.0).opacity, 0.0);
  EXPECT_GT(classify(ramp, 95.0).opacity, 0.3);
}

// The background is 10, 30 and 50 in equal parts (mean 30, standard deviation 16), the object 95 to 100.
TEST(PresetFit, automaticRampLeavesNoiseAroundTheObjectTransparent) {
  Grid grid;
  grid.dims = {10, 10, 10};
  std::vector<float> voxels(1000, 95.0f);
  for (std::size_t i = 0; i < 600; ++i)
    voxels[i] = 10.0f + 20.0f * static_cast<float>(i % 3);
  voxels[999] = 0.0f;
  voxels[998] = 100.0f;
  const TransferFunction ramp = automaticRamp(histogramOf(Volume(grid, voxels, {}, {}, {}), 100), grid);
  EXPECT_EQ(classify(ramp, 50.0).opacity, 0.0);
  EXPECT_GT(classify(ramp, 95.0).opacity, 0.3);
}

TEST(PresetFit, movesPresetsByTheirLandmarksAndLeavesOthersWhereTheyAre) {
  Preset mr = spanning(0, 1000, "MR");
  EXPECT_EQ(fittedTo(mr, histogramOf(twoClasses()), {}), mr) << "it says of no data that it was shaped on it";
  mr.landmarks = Landmarks{0.0, 250.0, 1000.0};
  const Preset fitted = fittedTo(mr, histogramOf(twoClasses()), {});
  EXPECT_NEAR(fitted.transferFunction.points.front().value, 5.0, 0.1);
  EXPECT_NEAR(fitted.transferFunction.points.back().value, 95.0, 0.1);
  EXPECT_EQ(fittedTo(spanning(0, 1000, "CT"), histogramOf(twoClasses()), {}), spanning(0, 1000, "CT"));
}

// Micro-CT of 0.02 mm is as opaque a voxel as a body of 1 mm; 0.4 mm is what a head has.
TEST(PresetFit, givesFineGridsTheirOwnUnitDistance) {
  Grid grid;
  const auto unitOf = [&](double spacingMm) {
    grid.spacingMm = {spacingMm, spacingMm, 2.0};
    const Histogram histogram = histogramOf(twoClasses());
    return std::pair(automaticRamp(histogram, grid).unitDistanceMm,
                     fittedTo(spanning(0, 1000, "MR"), histogram, grid).transferFunction.unitDistanceMm);
  };
  EXPECT_EQ(unitOf(0.02), std::pair(0.02, 0.02));
  EXPECT_EQ(unitOf(0.4), std::pair(0.4, 1.0));
  EXPECT_EQ(unitOf(1.5), std::pair(1.0, 1.0));
  grid.spacingMm = glm::dvec3(0.02);
  const Preset once = fittedTo(spanning(0, 1000, "CT"), histogramOf(twoClasses()), grid);
  EXPECT_EQ(fittedTo(once, histogramOf(twoClasses()), grid), once);
}

TEST(PresetFit, aHounsfieldPresetCanBeMovedOntoDataOfAnotherScale) {
  const Preset preset = withLandmarks(spanning(-1000, 1500, "CT"));
  const Preset fitted = fittedTo(preset, histogramOf(twoClasses()), {});
  EXPECT_NEAR(fitted.transferFunction.points.front().value, 5.0, 0.1);
  EXPECT_NEAR(fitted.transferFunction.points.back().value, 95.0, 0.1);
  EXPECT_FALSE(withLandmarks(spanning(0, 1000, "MR")).landmarks);
}

TEST(Landmarks, keepOrderAndAreMetExactly) {
  const Landmarks from{0.0, 250.0, 1000.0}, to{-3.0, 1.0, 6.0};
  EXPECT_EQ(moved(0.0, from, to), -3.0);
  EXPECT_EQ(moved(250.0, from, to), 1.0);
  EXPECT_EQ(moved(1000.0, from, to), 6.0);
  EXPECT_DOUBLE_EQ(moved(125.0, from, to), -1.0);
  EXPECT_DOUBLE_EQ(moved(1150.0, from, to), 7.0); // beyond: as between object and brightest
  EXPECT_DOUBLE_EQ(moved(-250.0, from, to), -7.0);
}

TEST(Landmarks, ascendEvenWhereAllVoxelsAreEqual) {
  Grid grid;
  grid.dims = {2, 2, 2};
  const Landmarks landmarks = landmarksOf(histogramOf(Volume(grid, std::vector<float>(8, 3.0f), {}, {}, {})));
  EXPECT_LT(landmarks.background, landmarks.object);
  EXPECT_LT(landmarks.object, landmarks.brightest);
}

// A CT head put into 8 bits from -200 to 2000 HU, in thousandths of its voxels: air and all that is darker at
// 0, soft tissue around 26, bone from 40 on in a tail without a hump, and what is denser than the scale at
// 255.
Histogram windowedHead(double tissueAt) {
  Histogram histogram{{-0.5, 255.5}, std::vector<std::uint64_t>(256, 0)};
  for (std::size_t bin = 0; bin < 256; ++bin) {
    const double away = (static_cast<double>(bin) - tissueAt) / 3.0;
    histogram.counts[bin] = static_cast<std::uint64_t>(500.0 + 50000.0 * std::exp(-away * away / 2.0));
  }
  histogram.counts.front() = 670000;
  histogram.counts.back() = 2000;
  return histogram;
}

TEST(Landmarks, tissueOfAScaleThatWasCutOffBeginsBelowItsHump) {
  for (const double tissue : {20.0, 26.0, 40.0}) {
    const Landmarks landmarks = landmarksOf(windowedHead(tissue));
    EXPECT_EQ(landmarks.background, 0.0);
    EXPECT_GT(landmarks.object, 0.0);
    EXPECT_LT(landmarks.object, tissue - 2.0 * 3.0) << "less than 2.3 % of the tissue is left out";
  }
}

// The window of a brain, 0 to 80 HU: bone lies beyond it, where no tissue of a head ends.
TEST(Landmarks, whatIsBrighterThanTheScaleDoesNotMoveWhereTissueBegins) {
  Histogram histogram = windowedHead(122.0);
  histogram.counts.back() = 86000;
  const double bright = landmarksOf(histogram).object;
  histogram.counts.back() = 0;
  EXPECT_EQ(bright, landmarksOf(histogram).object);
  EXPECT_LT(bright, 122.0 - 2.0 * 3.0);
  histogram.counts.assign(256, 0); // a mask is no scale that ends
  histogram.counts.front() = 700;
  histogram.counts.back() = 300;
  EXPECT_EQ(landmarksOf(histogram).object, 127.0)
      << "the middle of bins 0 to 254, which part it equally well";
}

// With every second value missing, as after scaling to more values than there were.
TEST(Landmarks, combsOfScaledValuesHideNoHump) {
  Histogram histogram = windowedHead(26.0);
  for (std::size_t bin = 1; bin < 255; bin += 2)
    histogram.counts[bin] = 0;
  EXPECT_LT(landmarksOf(histogram).object, 20.0);
}

// Padding of zeros, noise around 12 and a head around 120: its hump stands above the noise.
TEST(Landmarks, noiseBesidePaddingIsNoTissue) {
  Histogram histogram{{-0.5, 255.5}, std::vector<std::uint64_t>(256, 0)};
  for (std::size_t bin = 0; bin < 256; ++bin) {
    const double noise = (static_cast<double>(bin) - 12.0) / 5.0,
                 head = (static_cast<double>(bin) - 120.0) / 30.0;
    histogram.counts[bin] = static_cast<std::uint64_t>(20000.0 * std::exp(-noise * noise / 2.0) +
                                                       3000.0 * std::exp(-head * head / 2.0));
  }
  histogram.counts.front() = 600000;
  EXPECT_GT(landmarksOf(histogram).object, 12.0 + 3.0 * 5.0);
  EXPECT_LT(landmarksOf(histogram).object, 120.0 - 30.0);
}

// One class of air, one of the given value, in the share given.
Volume hounsfieldWith(double share, float value, const ScanHints& hints) {
  Grid grid;
  grid.dims = {10, 10, 10};
  std::vector<float> voxels(1000, -1000.0f);
  for (int i = 0; i < 300; ++i)
    voxels[static_cast<std::size_t>(i)] = i < 300 * share ? value : 40.0f;
  voxels[999] = 900.0f;
  VolumeInfo info;
  info.modality = "CT";
  info.unit = "HU";
  info.hints = hints;
  return Volume(grid, voxels, {}, {}, info);
}

std::string lookOf(const Volume& volume) {
  return firstLook(volume, histogramOf(volume));
}

TEST(FirstLook, ofCtGoesByContrastBodyPartAndLungs) {
  ScanHints hints;
  EXPECT_EQ(lookOf(hounsfieldWith(0.0, -800.0f, hints)), "CT bone and veil");
  EXPECT_EQ(lookOf(hounsfieldWith(0.4, -800.0f, hints)), "CT chest");
  hints.bodyPart = ScanHints::BodyPart::head;
  EXPECT_EQ(lookOf(hounsfieldWith(0.4, -800.0f, hints)), "CT bone and veil") << "the file says: a head";
  hints.bodyPart = ScanHints::BodyPart::chest;
  EXPECT_EQ(lookOf(hounsfieldWith(0.0, -800.0f, hints)), "CT chest");
  hints.isAngiography = true;
  EXPECT_EQ(lookOf(hounsfieldWith(0.0, -800.0f, hints)), "CT angiography");
}

TEST(FirstLook, ofOtherModalitiesGoesByWeightingAndContrast) {
  const auto look = [](const char* modality, ScanHints hints) {
    Grid grid;
    grid.dims = {2, 2, 2};
    VolumeInfo info;
    info.modality = modality;
    info.hints = hints;
    return lookOf(Volume(grid, std::vector<float>{0, 1, 2, 3, 4, 5, 6, 7}, {}, {}, info));
  };
  EXPECT_EQ(look("MR", {}), "MR head");
  EXPECT_EQ(look("MR", withHintsOf({}, "T2 TSE tra")), "MR T2 head");
  EXPECT_EQ(look("MR", withHintsOf({}, "FSE PD axial oblique")), "MR PD head");
  EXPECT_EQ(look("MR", withHintsOf({}, "TOF 3D")), "Vessels");
  EXPECT_EQ(look("PT", {}), "PET hot spots");
  EXPECT_EQ(look("US", {}), "Ultrasound surface");
  EXPECT_EQ(look("", withHintsOf({}, "mr_t1_head.nii.gz")), "MR head");
  EXPECT_EQ(look("", withHintsOf({}, "cta_brain_avm.nii")), "Vessels");
  EXPECT_EQ(look("", withHintsOf({}, "ct_thorax.vti")), "CT chest");
  EXPECT_EQ(look("", {}), "");
}

// Of 1,000 voxels the first 650 are 0. Of the others `dark` are 10, less than 15 % of the way to the
// brightest (100), the rest 50 to 100 in as many steps as there are.
Volume maskedWith(int dark, int steps, const std::string& modality, const std::string& format) {
  Grid grid;
  grid.dims = {10, 10, 10};
  std::vector<float> voxels(1000, 0.0f);
  for (int i = 650; i < 1000; ++i)
    voxels[static_cast<std::size_t>(i)] =
        i < 650 + dark ? 10.0f : 100.0f - 50.0f * static_cast<float>(i % steps) / static_cast<float>(steps);
  VolumeInfo info;
  info.modality = modality;
  info.format = format;
  return Volume(grid, voxels, {}, {}, info);
}

TEST(FirstLook, ofABrainWithoutItsSkullIsTheBrain) {
  EXPECT_EQ(lookOf(maskedWith(3, 50, "MR", "DICOM")), "MR skull-stripped brain");
  EXPECT_EQ(lookOf(maskedWith(3, 50, "", "NIfTI-1")), "MR skull-stripped brain");
  EXPECT_EQ(lookOf(maskedWith(3, 50, "", "VTI")), "") << "masked, but nothing says by whom";
  EXPECT_EQ(lookOf(maskedWith(4, 50, "MR", "DICOM")), "MR head") << "over 1 % of 350 are dark: skin, noise";
  EXPECT_EQ(lookOf(maskedWith(0, 5, "MR", "NIfTI-1")), "MR head") << "a label map";
  EXPECT_EQ(lookOf(maskedWith(0, 5, "", "NIfTI-1")), "");
}

TEST(ScanHints, takeWholeWordsAlone) {
  EXPECT_EQ(withHintsOf({}, "sector octopus amplitude structure"), ScanHints{});
  const ScanHints hints = withHintsOf({}, "S01_T1w-Brain.nii");
  EXPECT_EQ(hints.weighting, ScanHints::Weighting::t1);
  EXPECT_EQ(hints.bodyPart, ScanHints::BodyPart::head);
  EXPECT_EQ(withHintsOf(hints, "nothing of that kind"), hints);
}

TEST(ScanHints, tellTheWeightingOfASpinEcho) {
  EXPECT_EQ(weightingBy(500.0, 15.0), ScanHints::Weighting::t1);
  EXPECT_EQ(weightingBy(4000.0, 15.0), ScanHints::Weighting::pd);
  EXPECT_EQ(weightingBy(4000.0, 100.0), ScanHints::Weighting::t2);
  EXPECT_EQ(weightingBy(1400.0, 15.0), ScanHints::Weighting::unknown);
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
