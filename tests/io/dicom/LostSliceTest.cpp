// SPDX-License-Identifier: GPL-3.0-or-later
// A series that lacks slices because files of it are damaged must say so, whatever is left of them.
#include "SyntheticSeries.h"
#include "io/VolumeReader.h"
#include "support/FileBytes.h"

namespace limn::test {
namespace {

namespace fs = std::filesystem;

std::string nameOf(int number, const std::string& ending) {
  return "IM010" + std::to_string(number) + ending;
}

// Six slices, 2 mm apart.
void writeSeries(const fs::path& folder, const std::string& ending = "") {
  for (int k = 0; k < 6; ++k)
    slice(k + 1, 2.0 * k).write(folder / nameOf(k, ending));
}

// The refusal of a folder, or its warnings.
std::string saidOf(const fs::path& folder) {
  try {
    const auto volume = readDicom(folder, {}, {});
    std::string said;
    for (const Message& warning : volume->info().warnings)
      said += warning.english() + "\n";
    return said;
  } catch (const Error& error) {
    return error.what();
  }
}

// At every length of the file: before and within the preamble, between and within attributes and pixels.
void expectEveryCutIsSaid(const std::string& ending, int number) {
  const TemporaryFolder folder;
  writeSeries(folder.path(), ending);
  const fs::path cut = folder.path() / nameOf(number, ending);
  const std::string whole = bytesOfFile(cut);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    writeBytes(cut, whole.substr(0, length));
    EXPECT_NE(saidOf(folder.path()).find(nameOf(number, ending)), std::string::npos)
        << "cut at " << length << " of " << whole.size() << " bytes: " << saidOf(folder.path());
  }
}

TEST(DicomLostSlice, theLastSliceCutOffAtAnyByteIsNamed) {
  expectEveryCutIsSaid("", 5);
}

TEST(DicomLostSlice, aMiddleSliceCutOffAtAnyByteIsNamed) {
  expectEveryCutIsSaid(".dcm", 2);
}

TEST(DicomLostSlice, aSliceWithoutItsClassInFrontIsNamedWhereverItEnds) {
  const TemporaryFolder folder;
  writeSeries(folder.path());
  const std::string whole = slice(7, 12.0).text(0x00080016, "UI", "1.3.12.2.1107.5.9.7").bytes();
  for (int k = 0; k < 6; ++k)
    slice(k + 1, 2.0 * k).text(0x00080016, "UI", "1.3.12.2.1107.5.9.7").write(folder.path() / nameOf(k, ""));
  for (std::size_t length = 0; length < whole.size(); ++length) {
    writeBytes(folder.path() / nameOf(6, ""), whole.substr(0, length));
    EXPECT_NE(saidOf(folder.path()).find(nameOf(6, "")), std::string::npos) << "cut at " << length;
  }
}

TEST(DicomLostSlice, severalAreCountedAndTheFirstThreeNamed) {
  const TemporaryFolder folder;
  writeSeries(folder.path());
  for (int k = 1; k < 6; ++k)
    writeBytes(folder.path() / nameOf(k, ""), k % 2 == 0 ? "" : slice(k, k).bytes().substr(0, 250));
  EXPECT_NE(
      saidOf(folder.path())
          .find("5 DICOM files are damaged or cut off and were left out (IM0101, IM0102, IM0103 and 2 more)"),
      std::string::npos)
      << saidOf(folder.path());
}

TEST(DicomLostSlice, foreignFilesAreLeftAlone) {
  const TemporaryFolder folder;
  writeSeries(folder.path(), ".dcm");
  const std::string before = saidOf(folder.path());
  for (const char* name : {"README.txt", "._IM0102.dcm", ".DS_Store", "Thumbs.db", "DICOMDIR", "IM0102.jpg",
                           "IM0102.json", "LOCKFILE", "desktop.ini"})
    writeBytes(folder.path() / name, "");
  writeBytes(folder.path() / "VERSION", "1.2");
  EXPECT_EQ(saidOf(folder.path()), before);
}

TEST(DicomLostSlice, objectsWithoutPicturesByTheirKindAreLeftAlone) {
  const TemporaryFolder folder;
  writeSeries(folder.path(), ".dcm");
  const std::string before = saidOf(folder.path());
  // A report, a presentation state, a structure set, raw data, spectra, how two pictures of the eye lie to
  // each other, an inventory of images (of 2023), an index, a private kind.
  const std::vector<std::pair<std::string, std::string>> kinds = {
      {"1.2.840.10008.5.1.4.1.1.88.33", "SR"},
      {"1.2.840.10008.5.1.4.1.1.11.1", "PR"},
      {"1.2.840.10008.5.1.4.1.1.481.3", "RTSTRUCT"},
      {"1.2.840.10008.5.1.4.1.1.66", "CT"},
      {"1.2.840.10008.5.1.4.1.1.4.2", "MR"},
      {"1.2.840.10008.5.1.4.1.1.77.1.5.3", "SMR"},
      {"1.2.840.10008.5.1.4.1.1.201.1", "DOC"},
      {"1.2.840.10008.1.3.10", ""},
      {"1.3.12.2.1107.5.9.1", "MR"}};
  int number = 10;
  for (const auto& [kind, modality] : kinds) {
    DicomBuilder object;
    object.text(0x00080016, "UI", kind).text(0x00080018, "UI", "1.2.9." + std::to_string(number));
    object.text(0x00080060, "CS", modality).text(0x0020000E, "UI", "1.2.9");
    object.write(folder.path() / ("IM01" + std::to_string(number++) + ".dcm"));
  }
  EXPECT_EQ(saidOf(folder.path()), before);
}

TEST(DicomLostSlice, imagesOfAnyAgeAreMissedByTheirKind) {
  // CT; a segmentation; its labels in one map (of 2023); a picture on film, retired.
  for (const char* kind : {"1.2.840.10008.5.1.4.1.1.2", "1.2.840.10008.5.1.4.1.1.66.4",
                           "1.2.840.10008.5.1.4.1.1.66.7", "1.2.840.10008.5.1.1.29"}) {
    DicomBuilder object;
    object.text(0x00080016, "UI", kind).text(0x00080018, "UI", "1.2.9.1").text(0x00080060, "CS", "CT");
    const std::string refusal = dicomRefusal(object);
    EXPECT_NE(refusal.find("is cut off before its picture"), std::string::npos) << kind << ": " << refusal;
  }
}

TEST(DicomLostSlice, aCutFileByItselfSaysThatItIsCutOff) {
  const std::string refusal = dicomRefusal(slice(1, 0.0).without(0x7FE00010));
  EXPECT_NE(refusal.find("is cut off before its picture"), std::string::npos) << refusal;
  const TemporaryFolder folder;
  for (const std::size_t length : {0u, 50u, 131u}) {
    const fs::path file = folder.path() / "IM0100.dcm";
    writeBytes(file, slice(1, 0.0).bytes().substr(0, length));
    try {
      readVolume(file);
      ADD_FAILURE() << "read a file of " << length << " bytes";
    } catch (const Error& error) {
      const std::string said = error.what();
      EXPECT_NE(said.find(length == 0 ? "the file is empty" : "damaged or cut off"), std::string::npos)
          << said;
      EXPECT_NE(said.find(file.string()), std::string::npos) << said;
    }
  }
}

TEST(DicomLostSlice, theSliceThatRefusesASeriesIsNamedByItsWholePath) {
  const TemporaryFolder folder;
  writeSeries(folder.path());
  const fs::path cut = folder.path() / nameOf(3, "");
  const std::string whole = bytesOfFile(cut);
  writeBytes(cut, whole.substr(0, whole.size() - 2));
  EXPECT_NE(dicomRefusal(folder.path()).find(cut.string()), std::string::npos) << dicomRefusal(folder.path());
}

TEST(DicomLostSlice, missingSlicesAreCountedAndPlaced) {
  const TemporaryFolder folder;
  for (const int k : {0, 1, 2, 3, 6, 7, 8, 10, 11}) // 4 and 5 between 6 and 12 mm, 9 between 16 and 20 mm
    slice(k + 1, 2.0 * k).write(folder.path() / std::to_string(k));
  EXPECT_NE(saidOf(folder.path())
                .find("3 slices seem to be missing between 6.0 and 12.0 mm, 16.0 and 20.0 mm from the first"),
            std::string::npos)
      << saidOf(folder.path());
}

TEST(DicomLostSlice, foldersOfTheKernelAreNoSeries) {
  EXPECT_EQ(openDicom("/proc", {}), nullptr);
  EXPECT_EQ(openDicom("/sys", {}), nullptr);
  EXPECT_EQ(openDicom("/proc/self/stat", {}), nullptr);
}

} // namespace
} // namespace limn::test
