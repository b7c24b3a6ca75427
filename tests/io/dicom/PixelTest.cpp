// SPDX-License-Identifier: GPL-3.0-or-later
#include "SyntheticSeries.h"

namespace limn::test {
namespace {

std::shared_ptr<const Volume> readOne(const DicomBuilder& file) {
  TemporaryFolder folder;
  file.write(folder.path() / "image");
  return readDicom(folder.path() / "image", {}, {});
}

TEST(DicomPixels, aRescaleOfEachSliceMakesFloatsWithoutAWarning) {
  // As PET does: values = slope of the slice × stored.
  TemporaryFolder folder;
  for (int number = 1; number <= 2; ++number)
    slice(number, number)
        .text(0x00080060, "CS", "PT")
        .text(0x00541001, "CS", "BQML")
        .text(0x00281052, "DS", "0")
        .text(0x00281053, "DS", number == 1 ? "0.5" : "2")
        .write(folder.path() / std::to_string(number));
  const auto volume = readDicom(folder.path(), {}, {});
  EXPECT_EQ(voxelTypeName(volume->stored()), "float32");
  EXPECT_EQ(volume->value({2, 1, 0}), 0.5 * storedAt(1, 2, 1));
  EXPECT_EQ(volume->value({2, 1, 1}), 2.0 * storedAt(2, 2, 1));
  EXPECT_EQ(volume->info().unit, "Bq/ml");
  EXPECT_TRUE(volume->info().warnings.empty());
}

TEST(DicomPixels, paddingIsComparedInStoredValuesWithItsLimit) {
  // Stored 100 … 102 are padding: HU -924 … -922 count in no range.
  const auto volume = readOne(slice(1, 0.0).us(0x00280120, {100}).us(0x00280121, {102}));
  EXPECT_EQ(volume->invalidVoxels(), 3u);
  EXPECT_EQ(volume->range(), (ValueRange{110.0 - 1024.0, 112.0 - 1024.0}));
  EXPECT_EQ(volume->value({0, 0, 0}), 110.0 - 1024.0);
}

TEST(DicomPixels, negativePaddingOfSignedPixelsIsFoundWhateverItsRepresentation) {
  auto file = slice(1, 0.0).us(0x00280120, {63536}); // the bit pattern of -2000
  file.pixels(std::vector<std::int16_t>{-2000, 5, 6, 7, 8, -2000});
  const auto volume = readOne(file);
  EXPECT_EQ(volume->invalidVoxels(), 2u);
  EXPECT_EQ(volume->range(), (ValueRange{5.0 - 1024.0, 8.0 - 1024.0}));
}

TEST(DicomPixels, paddingOutsideTheStoredBitsIsPaddingStill) {
  // 12 bits are stored, the padding 63536 uses all 16 (seen in CT): it must not be cut to 2096.
  auto file =
      slice(1, 0.0).us(0x00280101, {12}).us(0x00280102, {11}).us(0x00280103, {0}).us(0x00280120, {63536});
  file.pixels(std::vector<std::uint16_t>{63536, 5, 6, 7, 8, 9});
  const auto volume = readOne(file);
  EXPECT_EQ(volume->invalidVoxels(), 1u);
  EXPECT_EQ(volume->range().highest, 9.0 - 1024.0);
}

TEST(DicomPixels, paddingSurvivesARescaleOfEachSlice) {
  TemporaryFolder folder;
  for (int number = 1; number <= 2; ++number)
    slice(number, number)
        .text(0x00281053, "DS", std::to_string(number))
        .us(0x00280120, {static_cast<std::uint16_t>(storedAt(number, 0, 0))})
        .write(folder.path() / std::to_string(number));
  const auto volume = readDicom(folder.path(), {}, {});
  EXPECT_EQ(volume->invalidVoxels(), 2u);
}

TEST(DicomPixels, theSignOfTwelveBitsIsExtended) {
  auto file = slice(1, 0.0).us(0x00280101, {12}).us(0x00280102, {11});
  // 0x0FFF is -1 and 0x0800 is -2048 in 12 bits; 0xFFFE has its sign repeated above.
  file.pixels(std::vector<std::uint16_t>{0x0FFF, 0x0800, 0xFFFE, 0x07FF, 0, 1});
  const auto volume = readOne(file.text(0x00281052, "DS", "0"));
  EXPECT_EQ(volume->value({0, 0, 0}), -1.0);
  EXPECT_EQ(volume->value({1, 0, 0}), -2048.0);
  EXPECT_EQ(volume->value({2, 0, 0}), -2.0);
  EXPECT_EQ(volume->value({0, 1, 0}), 2047.0);
  EXPECT_FALSE(warns(*volume, "bits"));
}

TEST(DicomPixels, bitsAboveTheStoredOnesAreIgnoredWithAWarning) {
  auto file = slice(1, 0.0).us(0x00280101, {12}).us(0x00280102, {11}).us(0x00280103, {0});
  const auto volume = readOne(file.pixels(std::vector<std::uint16_t>{0x1005, 1, 2, 3, 4, 5}));
  EXPECT_EQ(volume->value({0, 0, 0}), 5.0 - 1024.0);
  EXPECT_TRUE(warns(*volume, "bits were ignored"));
}

TEST(DicomPixels, theModalityLookUpTableIsAppliedAndClampedAtItsEnds) {
  // The table starts at stored 101: 101 → 7, 102 → 70, everything else is clamped to these two.
  DicomBuilder lut;
  lut.us(0x00283002, {2, 101, 16}).us(0x00283006, {7, 70});
  const auto volume = readOne(slice(1, 0.0).sequence(0x00283000, {lut}));
  EXPECT_EQ(volume->value({0, 0, 0}), 7.0);
  EXPECT_EQ(volume->value({1, 0, 0}), 7.0);
  EXPECT_EQ(volume->value({2, 0, 0}), 70.0);
  EXPECT_EQ(volume->value({2, 1, 0}), 70.0);
}

TEST(DicomPixels, invertedDisplayLeavesTheValuesAloneWithAWarning) {
  const auto volume = readOne(slice(1, 0.0).text(0x00280004, "CS", "MONOCHROME1"));
  EXPECT_EQ(volume->value({1, 1, 0}), storedAt(1, 1, 1) - 1024);
  EXPECT_TRUE(warns(*volume, "MONOCHROME1"));
}

TEST(DicomPixels, slicesOfMixedSignShareAWiderType) {
  TemporaryFolder folder;
  slice(1, 0.0).write(folder.path() / "signed");
  slice(2, 1.0)
      .us(0x00280103, {0})
      .pixels(std::vector<std::uint16_t>{65535, 1, 2, 3, 4, 5})
      .write(folder.path() / "unsigned");
  const auto volume = readDicom(folder.path(), {}, {});
  EXPECT_EQ(voxelTypeName(volume->stored()), "int32");
  EXPECT_EQ(volume->value({0, 0, 1}), 65535.0 - 1024.0);
}

DicomBuilder colour(const std::string& photometric, bool planar) {
  DicomBuilder file = slice(1, 0.0).us(0x00280002, {3}).us(0x00280006, {static_cast<std::uint16_t>(planar)});
  file.text(0x00280004, "CS", photometric).us(0x00280100, {8}).us(0x00280101, {8}).us(0x00280102, {7});
  return file.us(0x00280103, {0})
      .without(0x00281052)
      .without(0x00281053)
      .us(0x00280010, {1})
      .us(0x00280011, {2});
}

TEST(DicomPixels, colourBecomesLuminanceWithAWarning) {
  // ITU-R BT.601: 0.299 × 200 + 0.587 × 100 + 0.114 × 50 = 124.2; pure white stays 255.
  const auto together =
      readOne(colour("RGB", false).pixels(std::vector<std::uint8_t>{200, 100, 50, 255, 255, 255}));
  EXPECT_EQ(together->value({0, 0, 0}), 124.0);
  EXPECT_EQ(together->value({1, 0, 0}), 255.0);
  EXPECT_TRUE(warns(*together, "luminance"));
  const auto planes =
      readOne(colour("RGB", true).pixels(std::vector<std::uint8_t>{200, 255, 100, 255, 50, 255}));
  EXPECT_EQ(planes->value({0, 0, 0}), 124.0);
  EXPECT_EQ(planes->value({1, 0, 0}), 255.0);
  const auto ybr = readOne(colour("YBR_FULL", false).pixels(std::vector<std::uint8_t>{90, 1, 2, 80, 3, 4}));
  EXPECT_EQ(ybr->value({0, 0, 0}), 90.0);
  EXPECT_EQ(ybr->value({1, 0, 0}), 80.0);
}

TEST(DicomPixels, aPaletteBecomesItsLuminanceWithAWarning) {
  DicomBuilder file = slice(1, 0.0).text(0x00280004, "CS", "PALETTE COLOR");
  file.us(0x00280100, {8}).us(0x00280101, {8}).us(0x00280102, {7}).us(0x00280103, {0});
  for (const std::uint32_t channel : {0u, 1u, 2u}) {
    file.us(0x00281101 + channel, {2, 0, 16});
    file.us(0x00281201 + channel, {0, 60000});
  }
  file.without(0x00281052).without(0x00281053).pixels(std::vector<std::uint8_t>{0, 1, 0, 1, 0, 1});
  const auto volume = readOne(file);
  EXPECT_EQ(volume->value({0, 0, 0}), 0.0);
  EXPECT_EQ(volume->value({1, 0, 0}), 60000.0);
  EXPECT_TRUE(warns(*volume, "luminance"));
}

TEST(DicomPixels, morePixelsThanAnnouncedAreStated) {
  const auto volume = readOne(slice(1, 0.0).pixels(std::vector<std::int16_t>(12, 1)));
  EXPECT_EQ(volume->grid().dims.z, 1);
  EXPECT_TRUE(warns(*volume, "more pixels than its header announces"));
}

TEST(DicomPixels, ctWithoutARescaleClaimsNoHounsfieldUnits) {
  const auto volume = readOne(slice(1, 0.0).without(0x00281052).without(0x00281053).without(0x00281054));
  EXPECT_EQ(volume->info().unit, "");
  EXPECT_EQ(volume->value({1, 1, 0}), storedAt(1, 1, 1));
}

TEST(DicomPixels, runLengthsAreDecodedPlaneByPlane) {
  // Two segments: the high bytes (six times 1 as one run), then the low bytes 10 … 15 as a literal.
  std::string stream(64, '\0');
  stream[0] = 2;
  stream[4] = 64;
  stream[8] = 66;
  stream += std::string("\xFB\x01", 2) + "\x05\x0A\x0B\x0C\x0D\x0E\x0F" + std::string(1, '\0');
  DicomBuilder file = slice(1, 0.0).without(0x7FE00010);
  const auto volume = readOne(file.fragments("1.2.840.10008.1.2.5", {stream}));
  EXPECT_EQ(volume->value({0, 0, 0}), 266.0 - 1024.0);
  EXPECT_EQ(volume->value({2, 1, 0}), 271.0 - 1024.0);
}

TEST(DicomPixels, theOffsetsOfADoseGridPlaceItsFrames) {
  DicomBuilder file = slice(1, 5.0).text(0x00080060, "CS", "RTDOSE").text(0x00280008, "IS", "2");
  file.text(0x3004000C, "DS", "0\\2.5").text(0x3004000E, "DS", "0.001").text(0x30040002, "CS", "GY");
  file.without(0x00281052).without(0x00281053).without(0x00281054);
  file.pixels(std::vector<std::int16_t>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
  const auto volume = readOne(file);
  EXPECT_EQ(volume->grid().spacingMm.z, 2.5);
  EXPECT_DOUBLE_EQ(volume->value({0, 0, 1}), 0.007);
  EXPECT_EQ(volume->info().unit, "Gy");
}

} // namespace
} // namespace limn::test
