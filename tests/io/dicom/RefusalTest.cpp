// SPDX-License-Identifier: GPL-3.0-or-later
#include "SyntheticSeries.h"
#include "support/TestData.h"

#include <fstream>
#include <iterator>
#include <random>

namespace limn::test {
namespace {

void writeBytesTo(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string bytesIn(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

bool says(const std::string& refusal, const std::string& reason) {
  return refusal.find("image") != std::string::npos && refusal.find(reason) != std::string::npos;
}

// A structured report.
DicomBuilder report() {
  return DicomBuilder()
      .text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.88.11")
      .text(0x00080018, "UI", "1.2.3.5")
      .text(0x00080060, "CS", "SR");
}

TEST(DicomRefusal, pixelsThatEndEarly) {
  const std::string refusal = dicomRefusal(slice(1, 0.0).pixels(std::vector<std::int16_t>{1, 2, 3, 4}));
  EXPECT_TRUE(says(refusal, "need 12 bytes, and it holds 8")) << refusal;
}

TEST(DicomRefusal, aFileCutOffAtAnyByteIsNeverReadAsWhole) {
  TemporaryFolder folder;
  const std::string whole = slice(1, 0.0).bytes();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    writeBytesTo(folder.path() / "image", whole.substr(0, length));
    EXPECT_FALSE(dicomRefusal(folder.path() / "image").empty()) << "at byte " << length;
  }
}

TEST(DicomRefusal, sizesThatTheLengthOfTheFileContradicts) {
  EXPECT_TRUE(says(dicomRefusal(slice(1, 0.0).us(0x00280010, {65535}).us(0x00280011, {65535})), "cut off"));
  EXPECT_TRUE(says(dicomRefusal(slice(1, 0.0).text(0x00280008, "IS", "1000000")), "cut off"));
  EXPECT_TRUE(says(dicomRefusal(slice(1, 0.0).us(0x00280010, {0})), "its header is damaged"));
  EXPECT_TRUE(says(dicomRefusal(slice(1, 0.0).text(0x00280008, "IS", "-3")), "'-3' as its number of frames"));
  const DicomBuilder huge = slice(1, 0.0).without(0x7FE00010).us(0x00280010, {65535}).us(0x00280011, {65535});
  EXPECT_TRUE(says(dicomRefusal(DicomBuilder(huge).fragments("1.2.840.10008.1.2.5", {std::string(70, 'x')})),
                   "damaged"));
}

TEST(DicomRefusal, bitsThatContradictThemselves) {
  EXPECT_TRUE(says(dicomRefusal(slice(1, 0.0).us(0x00280101, {17})), "contradicts itself"));
  EXPECT_TRUE(says(dicomRefusal(slice(1, 0.0).us(0x00280100, {12})), "12 bits per pixel"));
  EXPECT_TRUE(says(dicomRefusal(slice(1, 0.0).text(0x00281053, "DS", "0")), "slope of 0"));
}

TEST(DicomRefusal, whatIsNoVolume) {
  EXPECT_TRUE(says(dicomRefusal(report()), "holds no image"));
  EXPECT_TRUE(
      says(dicomRefusal(slice(1, 0.0).text(0x00080008, "CS", "ORIGINAL\\PRIMARY\\MOSAIC")), "mosaic"));
  DicomBuilder film = slice(1, 0.0).text(0x00280008, "IS", "2").us(0x00280009, {0x0018, 0x1063});
  film.without(0x00200032).pixels(std::vector<std::int16_t>(12, 1));
  EXPECT_TRUE(says(dicomRefusal(film), "is a film"));
  DicomBuilder video = slice(1, 0.0).without(0x7FE00010);
  EXPECT_TRUE(
      says(dicomRefusal(video.fragments("1.2.840.10008.1.2.4.102", {std::string(100, 'x')})), "is a video"));
}

TEST(DicomRefusal, compressedPixelsThatDisagreeWithTheHeader) {
  // A baseline JPEG header of 8 × 8 pixels, one component of 8 bits; the file says 3 × 2 of 16 bits.
  std::string stream("\xFF\xD8\xFF\xC0\x00\x0B\x08\x00\x08\x00\x08\x01\x01\x11\x00\xFF\xD9\x00", 18);
  DicomBuilder file = slice(1, 0.0).without(0x7FE00010);
  EXPECT_TRUE(says(dicomRefusal(file.fragments("1.2.840.10008.1.2.4.50", {stream})), "8 × 8 pixels"));
  EXPECT_TRUE(
      says(dicomRefusal(file.fragments("1.2.840.10008.1.2.4.90", {std::string(100, 'x')})), "damaged"));
  EXPECT_TRUE(says(dicomRefusal(file.fragments("1.2.3.4", {stream})), "does not read"));
}

TEST(DicomRefusal, aFolderWithoutImagesSaysWhatItHolds) {
  TemporaryFolder folder;
  writeBytesTo(folder.path() / "note.txt", "no image");
  EXPECT_EQ(openDicom(folder.path(), {}), nullptr);
  EXPECT_EQ(openDicom(folder.path() / "note.txt", {}), nullptr);
  EXPECT_EQ(openDicom(folder.path() / "missing", {}), nullptr);
  report().write(folder.path() / "report");
  ASSERT_NE(openDicom(folder.path(), {}), nullptr);
  EXPECT_TRUE(openDicom(folder.path(), {})->summaries().empty());
  EXPECT_NE(dicomRefusal(folder.path()).find("without images"), std::string::npos);
}

TEST(DicomRefusal, damagedHeadersInAFolderAreCountedInAWarning) {
  TemporaryFolder folder;
  for (int k = 0; k < 3; ++k)
    slice(k + 1, k).write(folder.path() / std::to_string(k));
  writeBytesTo(folder.path() / "torn", slice(4, 3.0).bytes().substr(0, 300));
  const auto volume = readDicom(folder.path(), {}, {});
  EXPECT_EQ(volume->grid().dims.z, 3);
  EXPECT_TRUE(warns(*volume, "1 DICOM file is damaged or cut off and was left out (torn)"));
}

TEST(DicomRefusal, randomlyDamagedFilesEndInAVolumeOrASentence) {
  TemporaryFolder folder;
  std::vector<std::string> originals = {slice(1, 0.0).bytes()};
  for (const char* real :
       {"data/odd_dicom/MR_small_RLE.dcm", "data/odd_dicom/JPGExtended.dcm",
        "data/odd_dicom/MR_small_jp2klossless.dcm", "data/odd_dicom/MR_small_jpeg_ls_lossless.dcm",
        "data/ct_head_cranium/ts_variants/jpeg_lossless_sv1/IM0001.dcm",
        "data/ct_head_cranium/ts_variants/deflated/IM0001.dcm"})
    if (std::filesystem::exists(sharedFolder() / real))
      originals.push_back(bytesIn(sharedFolder() / real));
  std::mt19937 random(20240131);
  for (const std::string& original : originals)
    for (int trial = 0; trial < 150; ++trial) {
      std::string damaged = original;
      for (int change = 0; change < 8; ++change)
        damaged[random() % damaged.size()] = static_cast<char>(random());
      if (trial % 3 == 0)
        damaged.resize(random() % damaged.size());
      writeBytesTo(folder.path() / "image", damaged);
      const std::string refusal = dicomRefusal(folder.path() / "image");
      EXPECT_TRUE(refusal.empty() || refusal.back() == '.') << refusal;
    }
}

} // namespace
} // namespace limn::test
