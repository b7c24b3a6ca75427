// SPDX-License-Identifier: GPL-3.0-or-later
#include "SyntheticSeries.h"

#include <cmath>

namespace limn::test {
namespace {

// Coordinates in the files are decimal text; what is left is rounding in double.
constexpr double rounding = 1e-9;

std::string name(int index) {
  return "image" + std::to_string(index);
}

void expectSliceOrder(const Volume& volume, const std::vector<int>& numbers) {
  ASSERT_EQ(volume.grid().dims, glm::ivec3(sliceColumns, sliceRows, static_cast<int>(numbers.size())));
  for (int k = 0; k < volume.grid().dims.z; ++k)
    for (int j = 0; j < sliceRows; ++j)
      for (int i = 0; i < sliceColumns; ++i)
        EXPECT_EQ(volume.value({i, j, k}), storedAt(numbers[static_cast<std::size_t>(k)], i, j) - 1024);
}

TEST(DicomSeries, slicesAreSortedByPositionAndNotByNameOrNumber) {
  TemporaryFolder folder;
  slice(1, 4.0).write(folder.path() / "a");
  slice(2, 0.0).write(folder.path() / "b");
  slice(3, 2.0).write(folder.path() / "c");
  const auto volume = readDicom(folder.path(), {}, {});
  expectSliceOrder(*volume, {2, 3, 1});
  EXPECT_EQ(volume->info().unit, "HU");
  EXPECT_EQ(volume->info().modality, "CT");
  EXPECT_TRUE(volume->info().orientationKnown);
  EXPECT_TRUE(volume->info().warnings.empty());
  EXPECT_EQ(voxelTypeName(volume->stored()), "int16");
}

TEST(DicomSeries, pixelSpacingNamesTheDistanceOfRowsFirst) {
  TemporaryFolder folder;
  slice(1, 0.0).write(folder.path() / "a");
  slice(2, 2.5).write(folder.path() / "b");
  const auto volume = readDicom(folder.path(), {}, {});
  const Grid& grid = volume->grid();
  EXPECT_NEAR(glm::length(grid.spacingMm - glm::dvec3(0.5, 0.75, 2.5)), 0.0, rounding);
  EXPECT_NEAR(glm::length(grid.originMm - glm::dvec3(-10.0, -20.0, 0.0)), 0.0, rounding);
  EXPECT_EQ(grid.direction, glm::dmat3(1.0));
}

TEST(DicomSeries, aSagittalSeriesAcquiredRightToLeftKeepsEveryVoxelInItsPlace) {
  // Rows run to the back (+y), columns to the feet (-z): the normal y × -z is -x, so the grid ascends to the
  // right.
  TemporaryFolder folder;
  for (int number = 1; number <= 4; ++number) {
    const double x = 3.0 * number;
    slice(number, 0.0)
        .text(0x00200037, "DS", "0\\1\\0\\0\\0\\-1")
        .text(0x00200032, "DS", std::to_string(x) + "\\-50\\80")
        .write(folder.path() / name(number));
  }
  const auto volume = readDicom(folder.path(), {}, {});
  expectSliceOrder(*volume, {4, 3, 2, 1});
  EXPECT_NEAR(glm::determinant(volume->grid().direction), 1.0, rounding);
  // Pixel (2, 1) of image 1 lies 2 × 0.5 mm back and 0.75 mm down from (3, -50, 80).
  const glm::dvec3 world = indexToWorld(volume->grid(), {2, 1, 3});
  EXPECT_NEAR(glm::length(world - glm::dvec3(3.0, -49.0, 79.25)), 0.0, rounding);
}

TEST(DicomSeries, smallIrregularitiesAreAveragedWithAWarning) {
  // Distances 2, 2.08, 1.94 mm: at most 4 % off the median 2; the mean is 6.02 / 3.
  TemporaryFolder folder;
  const double heights[] = {0.0, 2.0, 4.08, 6.02};
  for (int k = 0; k < 4; ++k)
    slice(k + 1, heights[k]).write(folder.path() / name(k));
  const auto volume = readDicom(folder.path(), {}, {});
  expectSliceOrder(*volume, {1, 2, 3, 4});
  EXPECT_NEAR(volume->grid().spacingMm.z, 6.02 / 3.0, rounding);
  EXPECT_TRUE(warns(*volume, "1.940 to 2.080 mm apart"));
}

TEST(DicomSeries, aMissingSliceIsInterpolatedWithAWarning) {
  // Slices at 0, 1, 2, 4, 5: the grid has a plane at 3 mm, half way between the images 3 and 4.
  TemporaryFolder folder;
  const double heights[] = {0.0, 1.0, 2.0, 4.0, 5.0};
  for (int k = 0; k < 5; ++k)
    slice(k + 1, heights[k]).write(folder.path() / name(k));
  const auto volume = readDicom(folder.path(), {}, {});
  ASSERT_EQ(volume->grid().dims.z, 6);
  EXPECT_NEAR(volume->grid().spacingMm.z, 1.0, rounding);
  EXPECT_EQ(volume->value({1, 1, 2}), storedAt(3, 1, 1) - 1024);
  EXPECT_EQ(volume->value({1, 1, 3}), (storedAt(3, 1, 1) + storedAt(4, 1, 1)) / 2 - 1024);
  EXPECT_EQ(volume->value({1, 1, 4}), storedAt(4, 1, 1) - 1024);
  EXPECT_EQ(volume->invalidVoxels(), 0u);
  EXPECT_TRUE(warns(*volume, "interpolated"));
}

TEST(DicomSeries, interpolationNeverMixesPaddingIntoAValue) {
  // Pixel (0, 0) of the slice at 4 mm is padding. At 3 mm, half way, the nearest is taken (the upper of two
  // as near): padding as well, and no value between 300 and 400.
  TemporaryFolder folder;
  const double heights[] = {0.0, 1.0, 2.0, 4.0, 5.0};
  for (int k = 0; k < 5; ++k)
    slice(k + 1, heights[k]).us(0x00280120, {400}).write(folder.path() / name(k));
  const auto volume = readDicom(folder.path(), {}, {});
  EXPECT_EQ(volume->value({1, 0, 3}), (storedAt(3, 1, 0) + storedAt(4, 1, 0)) / 2 - 1024);
  EXPECT_TRUE(volume->invalidMask()[voxelOffset(volume->grid().dims, 0, 0, 4)]);
  EXPECT_EQ(volume->invalidVoxels(), 2u);
}

TEST(DicomSeries, aWideGapIsRefusedWithItsPlaceAndWidth) {
  TemporaryFolder folder;
  const double heights[] = {0.0, 1.0, 2.0, 20.0, 21.0};
  for (int k = 0; k < 5; ++k)
    slice(k + 1, heights[k]).write(folder.path() / name(k));
  const std::string refusal = dicomRefusal(folder.path());
  EXPECT_NE(refusal.find("gap of 18.000 mm after slice 3"), std::string::npos) << refusal;
}

TEST(DicomSeries, aTiltedGantryIsResampledOntoAnUprightGrid) {
  // Every slice is one row (0.75 mm) further back than the one 2 mm below: row j of image k lies at grid row
  // j + k - 1.
  TemporaryFolder folder;
  for (int number = 1; number <= 3; ++number)
    slantingSlice(number).write(folder.path() / name(number));
  const auto volume = readDicom(folder.path(), {}, {});
  ASSERT_EQ(volume->grid().dims, glm::ivec3(3, 4, 3));
  EXPECT_NEAR(volume->grid().spacingMm.z, 2.0, rounding);
  for (int number = 1; number <= 3; ++number)
    for (int j = 0; j < sliceRows; ++j)
      EXPECT_EQ(volume->value({1, j + number - 1, number - 1}), storedAt(number, 1, j) - 1024);
  // Of 4 × 3 × 3 voxels the slices cover 2 × 3 × 3; the rest holds no data and repeats the smallest value.
  EXPECT_EQ(volume->invalidVoxels(), 18u);
  EXPECT_EQ(volume->range(), (ValueRange{storedAt(1, 0, 0) - 1024.0, storedAt(3, 2, 1) - 1024.0}));
  // atan(0.75 / 2) = 20.6°.
  EXPECT_TRUE(warns(*volume, "slant by 20.6°"));
  EXPECT_TRUE(volume->info().slants);
}

TEST(DicomSeries, copiesOfAnImageAreLeftOutWithAWarning) {
  TemporaryFolder folder;
  slice(1, 0.0).write(folder.path() / "a");
  slice(2, 1.0).write(folder.path() / "b");
  slice(2, 1.0).write(folder.path() / "c");
  const auto volume = readDicom(folder.path(), {}, {});
  expectSliceOrder(*volume, {1, 2});
  EXPECT_TRUE(warns(*volume, "1 image is a copy"));
}

TEST(DicomSeries, anotherImageAtTheSamePositionIsLeftOutWithAWarning) {
  TemporaryFolder folder;
  for (int number = 1; number <= 4; ++number)
    slice(number, number).write(folder.path() / name(number));
  slice(9, 2.0).write(folder.path() / "again");
  const auto volume = readDicom(folder.path(), {}, {});
  expectSliceOrder(*volume, {1, 2, 3, 4});
  EXPECT_TRUE(warns(*volume, "repeats some positions (5 images at 4 positions)"));
}

TEST(DicomSeries, theFirstPhaseOfATimeSeriesIsShownWithAWarning) {
  // Three phases of three slices; phase p has the images 3p - 2 … 3p.
  TemporaryFolder folder;
  for (int phase = 3; phase >= 1; --phase)
    for (int k = 0; k < 3; ++k)
      slice(3 * phase - 2 + k, k)
          .text(0x00200100, "IS", std::to_string(phase))
          .write(folder.path() / name(10 * phase + k));
  const auto volume = readDicom(folder.path(), {}, {});
  expectSliceOrder(*volume, {1, 2, 3});
  EXPECT_TRUE(warns(*volume, "several phases (9 images at 3 positions)"));
  EXPECT_TRUE(warns(*volume, "temporal position 1 of 3"));
}

TEST(DicomSeries, triggerTimesThatDifferFromSliceToSliceAreRankedAtEachPosition) {
  TemporaryFolder folder;
  for (int k = 0; k < 3; ++k)
    for (int phase = 0; phase < 2; ++phase)
      slice(2 * k + 2 - phase, k)
          .text(0x00181060, "DS", std::to_string(400 * phase + 7 * k))
          .write(folder.path() / name(2 * k + phase));
  const auto volume = readDicom(folder.path(), {}, {});
  expectSliceOrder(*volume, {2, 4, 6});
  EXPECT_TRUE(warns(*volume, "the first trigger time at each position"));
}

TEST(DicomSeries, theLargestOfTwoSeriesIsShownAndTheOtherNamedAndChosenByItsNumber) {
  TemporaryFolder folder;
  for (int k = 0; k < 2; ++k)
    slice(k + 1, k)
        .text(0x0020000E, "UI", "1.2.3.5")
        .text(0x0008103E, "LO", "Scout")
        .write(folder.path() / name(k));
  for (int k = 0; k < 3; ++k)
    slice(k + 5, k).text(0x0008103E, "LO", "Thin").write(folder.path() / "below" / name(k));
  const auto list = openDicom(folder.path(), {})->summaries();
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0].description, "Thin");
  EXPECT_EQ(list[0].dims, glm::ivec3(sliceColumns, sliceRows, 3));
  EXPECT_EQ(list[1].number, 2);
  const auto largest = readDicom(folder.path(), {}, {});
  expectSliceOrder(*largest, {5, 6, 7});
  EXPECT_TRUE(warns(*largest, "the others are 2 (CT 'Scout'"));
  ReadOptions second;
  second.series = 2;
  expectSliceOrder(*readDicom(folder.path(), second, {}), {1, 2});
  second.series = 3;
  EXPECT_THROW(readDicom(folder.path(), second, {}), Error);
}

TEST(DicomSeries, picturesOfAnotherSizeOrOrientationAreSeriesOfTheirOwn) {
  TemporaryFolder folder;
  for (int k = 0; k < 3; ++k)
    slice(k + 1, k).write(folder.path() / name(k));
  slice(8, 9.0).us(0x00280010, {3}).us(0x00280011, {2}).write(folder.path() / "other size");
  slice(9, 9.0).text(0x00200037, "DS", "0\\1\\0\\0\\0\\-1").write(folder.path() / "other orientation");
  EXPECT_EQ(openDicom(folder.path(), {})->summaries().size(), 3u);
  expectSliceOrder(*readDicom(folder.path(), {}, {}), {1, 2, 3});
}

TEST(DicomSeries, partsInTwoFoldersAreJoinedUnlessTheyRepeatEachOther) {
  TemporaryFolder folder;
  for (int k = 0; k < 4; ++k)
    slice(k + 1, k).write(folder.path() / (k < 2 ? "first" : "second") / name(k));
  expectSliceOrder(*readDicom(folder.path(), {}, {}), {1, 2, 3, 4});
  for (int k = 0; k < 4; ++k)
    slice(k + 1, k).write(folder.path() / "third" / name(k));
  EXPECT_GT(openDicom(folder.path(), {})->summaries().size(), 1u);
}

TEST(DicomSeries, withoutPositionsTheOrderIsThatOfTheNumbersAndTheOrientationUnknown) {
  TemporaryFolder folder;
  slice(2, 0.0).without(0x00200032).text(0x00180088, "DS", "3").write(folder.path() / "a");
  slice(1, 0.0).without(0x00200032).text(0x00180088, "DS", "3").write(folder.path() / "b");
  const auto volume = readDicom(folder.path(), {}, {});
  expectSliceOrder(*volume, {1, 2});
  EXPECT_FALSE(volume->info().orientationKnown);
  EXPECT_EQ(volume->grid().spacingMm.z, 3.0);
  EXPECT_TRUE(warns(*volume, "orientation is unknown"));
}

TEST(DicomSeries, aSpacingGivenByHandReplacesAMissingOne) {
  TemporaryFolder folder;
  slice(1, 0.0).without(0x00280030).write(folder.path() / "a");
  const auto assumed = readDicom(folder.path() / "a", {}, {});
  EXPECT_FALSE(assumed->info().spacingKnown);
  EXPECT_TRUE(warns(*assumed, "how large its pixels are"));
  EXPECT_TRUE(warns(*assumed, "how thick its slices are"));
  ReadOptions options;
  options.spacingMm = glm::dvec3(0.4, 0.4, 5.0);
  const auto given = readDicom(folder.path() / "a", options, {});
  EXPECT_TRUE(given->info().spacingKnown);
  EXPECT_FALSE(warns(*given, "assumed"));
  EXPECT_EQ(given->grid().spacingMm, *options.spacingMm);
}

TEST(DicomSeries, framesOfOneFileArePlacedByTheirFunctionalGroups) {
  // Frames are stored from the top down, each with its own slope: they come out ascending, as float.
  TemporaryFolder folder;
  std::vector<DicomBuilder> perFrame;
  for (int f = 0; f < 3; ++f) {
    DicomBuilder position, values, groups;
    position.text(0x00200032, "DS", "-10\\-20\\" + std::to_string(10 - 2 * f));
    values.text(0x00281052, "DS", "0").text(0x00281053, "DS", std::to_string(f + 1));
    perFrame.push_back(groups.sequence(0x00209113, {position}).sequence(0x00289145, {values}));
  }
  DicomBuilder orientation, measures, shared;
  orientation.text(0x00200037, "DS", "1\\0\\0\\0\\1\\0");
  measures.text(0x00280030, "DS", "0.75\\0.5");
  shared.sequence(0x00209116, {orientation}).sequence(0x00289110, {measures});
  DicomBuilder file = slice(1, 0.0);
  for (const std::uint32_t tag :
       {0x00200032u, 0x00200037u, 0x00280030u, 0x00281052u, 0x00281053u, 0x00281054u})
    file.without(tag);
  file.sequence(0x52009229, {shared}).sequence(0x52009230, perFrame).text(0x00280008, "IS", "3");
  file.pixels(std::vector<std::int16_t>{1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3});
  file.write(folder.path() / "enhanced");
  const auto volume = readDicom(folder.path() / "enhanced", {}, {});
  ASSERT_EQ(volume->grid().dims, glm::ivec3(3, 2, 3));
  EXPECT_NEAR(glm::length(volume->grid().spacingMm - glm::dvec3(0.5, 0.75, 2.0)), 0.0, rounding);
  EXPECT_NEAR(glm::length(volume->grid().originMm - glm::dvec3(-10.0, -20.0, 6.0)), 0.0, rounding);
  EXPECT_EQ(volume->value({0, 0, 0}), 9.0);
  EXPECT_EQ(volume->value({0, 0, 2}), 1.0);
  EXPECT_TRUE(volume->info().warnings.empty());
}

TEST(DicomSeries, whoThePatientIsStandsInTheLabelOnlyAndInUtf8) {
  TemporaryFolder folder;
  for (int k = 0; k < 2; ++k)
    slice(k + 1, k)
        .text(0x00080005, "CS", "ISO_IR 100")
        .text(0x00100010, "PN", "M\xFCller^Anna^Maria")
        .text(0x00100020, "LO", "4711")
        .text(0x00080020, "DA", "20240131")
        .write(folder.path() / name(k));
  const auto volume = readDicom(folder.path(), {}, {});
  EXPECT_EQ(volume->info().patient.name, "Müller, Anna Maria");
  EXPECT_EQ(volume->info().patient.id, "4711");
  EXPECT_EQ(volume->info().patient.studyDate, "2024-01-31");
  EXPECT_FALSE(warns(*volume, "Anna"));
}

TEST(DicomSeries, readingReportsItsProgressAndStopsWhenAsked) {
  TemporaryFolder folder;
  for (int k = 0; k < 3; ++k)
    slice(k + 1, k).write(folder.path() / name(k));
  double last = 0.0;
  Progress progress;
  progress.report = [&](double fraction, const Message&) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1.0);
    last = fraction;
  };
  readDicom(folder.path(), {}, progress);
  EXPECT_GT(last, 0.5);
  int asked = 0;
  progress.report = {};
  progress.isCancelled = [&] { return ++asked > 4; };
  EXPECT_THROW(readDicom(folder.path(), {}, progress), Cancelled);
}

} // namespace
} // namespace limn::test
