// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/NiftiBytes.h"
#include "support/TestData.h"

namespace limn {
namespace {

using namespace test;

void writeNifti(const std::filesystem::path& file, std::size_t side) {
  NiftiFields fields;
  const int n = static_cast<int>(side);
  fields.dim = {3, n, n, n, 1, 1, 1, 1};
  writeBytes(file, niftiFile(fields, bytesOf(rising<std::int16_t>(side * side * side))));
}

TEST(VolumeReader, whatIsNoVolumeIsRefusedWithASentence) {
  const TemporaryFolder folder;
  EXPECT_NE(refusalOf(folder.path() / "none.nii").find("no such file"), std::string::npos);
  writeBytes(folder.path() / "empty.nii", "");
  EXPECT_NE(refusalOf(folder.path() / "empty.nii").find("empty"), std::string::npos);
  writeBytes(folder.path() / "letter.doc", std::string("\xD0\xCF\x11\xE0", 4));
  EXPECT_NE(refusalOf(folder.path() / "letter.doc").find("no known kind"), std::string::npos);
  for (const char* name : {"letter.txt", "letter"}) {
    writeBytes(folder.path() / name, "Dear colleague,\r\n\there is the volume of M\xC3\xA4rz.\n");
    const std::string refusal = refusalOf(folder.path() / name);
    EXPECT_NE(refusal.find("it is a text, not a volume"), std::string::npos) << refusal;
    EXPECT_EQ(refusal.find(".mhd"), std::string::npos) << refusal;
  }
  EXPECT_NE(refusalOf(folder.path()).find("holds no DICOM"), std::string::npos);
  writeBytes(folder.path() / "a.raw", std::string(1000, '\7'));
  EXPECT_NE(refusalOf(folder.path() / "a.raw").find(".mhd"), std::string::npos);
  writeBytes(folder.path() / "a.nhdr", "NRRD0004\n");
  EXPECT_NE(refusalOf(folder.path() / "a.raw").find("open a.nhdr instead"), std::string::npos);
}

TEST(VolumeReader, theContentCountsNotTheName) {
  const TemporaryFolder folder;
  writeNifti(folder.path() / "volume.dcm", 4);
  EXPECT_EQ(readVolume(folder.path() / "volume.dcm")->info().format, "NIfTI-1");
}

TEST(VolumeReader, aGivenSpacingHoldsAgainstTheFiles) {
  const TemporaryFolder folder;
  writeNifti(folder.path() / "a.nii", 4);
  ReadOptions options;
  options.spacingMm = glm::dvec3(0.1, 0.2, 0.3);
  EXPECT_EQ(readVolume(folder.path() / "a.nii", options)->grid().spacingMm, glm::dvec3(0.1, 0.2, 0.3));
}

TEST(VolumeReader, progressRisesToOneAndCancellingStops) {
  const TemporaryFolder folder;
  writeNifti(folder.path() / "a.nii", 128); // 4 MiB: several steps of reading
  double last = 0.0;
  int reports = 0;
  Progress progress;
  progress.report = [&](double fraction, const Message&) {
    EXPECT_GE(fraction, last);
    last = fraction;
    ++reports;
  };
  readVolume(folder.path() / "a.nii", {}, progress);
  EXPECT_EQ(last, 1.0);
  EXPECT_GT(reports, 3);
  progress.isCancelled = [&] { return true; };
  EXPECT_THROW(readVolume(folder.path() / "a.nii", {}, progress), Cancelled);
}

TEST(VolumeReader, onlyDicomHasSeries) {
  const TemporaryFolder folder;
  writeNifti(folder.path() / "a.nii", 4);
  EXPECT_EQ(dicomAt(folder.path() / "a.nii", {}), nullptr);
  EXPECT_EQ(dicomAt(folder.path(), {}), nullptr);
  EXPECT_THROW(dicomAt(folder.path() / "none", {}), Error);
}

TEST(VolumeReader, rawVoxelsWithATextAreRefusedWithAWayOut) {
  LIMN_NEEDS_SHARED("data/classic/tooth/raw_le/tooth_103x94x161_u16le.raw");
  const auto folder = sharedFolder() / "data/classic/tooth/raw_le";
  EXPECT_NE(refusalOf(folder / "tooth_103x94x161_u16le.raw").find(".mhd"), std::string::npos);
  EXPECT_NE(refusalOf(folder / "tooth_103x94x161_u16le.txt").find(".mhd"), std::string::npos);
}

} // namespace
} // namespace limn
