// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/VolumeBytes.h"
#include "support/TestData.h"

#include <archive.h>
#include <archive_entry.h>

#include <map>

namespace limn {
namespace {

using namespace test;

void writeTar(const std::filesystem::path& file, const std::map<std::string, std::string>& entries) {
  archive* out = archive_write_new();
  archive_write_add_filter_gzip(out);
  archive_write_set_format_ustar(out);
  archive_write_open_filename(out, file.c_str());
  for (const auto& [name, bytes] : entries) {
    archive_entry* entry = archive_entry_new();
    archive_entry_set_pathname(entry, ("project/" + name).c_str());
    archive_entry_set_size(entry, static_cast<la_int64_t>(bytes.size()));
    archive_entry_set_filetype(entry, AE_IFREG);
    archive_entry_set_perm(entry, 0644);
    archive_write_header(out, entry);
    archive_write_data(out, bytes.data(), bytes.size());
    archive_entry_free(entry);
  }
  archive_write_free(out);
}

// A project of 2 columns, 3 rows and 4 slices.
std::string project(const std::string& more = "<key>orientation</key><integer>1</integer>") {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?><plist version=\"1.0\"><dict>" + more +
         "<key>modality</key><string>CT</string><key>name</key><string>A Name</string>"
         "<key>matrix</key><dict><key>dtype</key><string>int16</string><key>filename</key>"
         "<string>matrix.dat</string><key>shape</key><array><integer>4</integer><integer>3</integer>"
         "<integer>2</integer></array></dict><key>spacing</key><array><real>2</real><real>3</real>"
         "<real>4</real></array></dict></plist>";
}

TEST(InVesalius, axialSlicesStandOnTheirFeetAndLookToTheFront) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.inv3";
  writeTar(file, {{"main.plist", project()}, {"matrix.dat", bytesOf(rising<std::int16_t>(24))}});
  const auto volume = readVolume(file);
  EXPECT_EQ(volume->grid().dims, glm::ivec3(2, 3, 4));
  EXPECT_EQ(volume->value({1, 2, 3}), 23.0);
  // Centred: voxel (1, 2, 3) is half a box less half a voxel from 0; rows run to the front, against +y of
  // LPS.
  expectNear(indexToWorld(volume->grid(), {1, 2, 3}), {1, -3, 6});
  EXPECT_TRUE(volume->info().orientationKnown);
  EXPECT_EQ(volume->info().modality, "CT");
  EXPECT_EQ(volume->info().unit, "HU");
  EXPECT_EQ(volume->info().patient.name, "A Name");
}

TEST(InVesalius, otherSlicesAndImportedFilesHaveNoKnownOrientation) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.inv3";
  const std::string matrix = bytesOf(rising<std::int16_t>(24));
  for (const char* more :
       {"<key>orientation</key><integer>2</integer>", "",
        "<key>orientation</key><integer>1</integer><key>affine</key><array><real>1</real></array>"}) {
    writeTar(file, {{"main.plist", project(more)}, {"matrix.dat", matrix}});
    EXPECT_FALSE(readVolume(file)->info().orientationKnown) << more;
  }
}

TEST(InVesalius, incompleteProjectsAreRefused) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.inv3";
  const std::string matrix = bytesOf(rising<std::int16_t>(24));
  writeTar(file, {{"main.plist", project()}});
  EXPECT_NE(refusalOf(file).find("matrix.dat"), std::string::npos);
  writeTar(file, {{"matrix.dat", matrix}});
  EXPECT_NE(refusalOf(file).find("main.plist"), std::string::npos);
  writeTar(file, {{"main.plist", project()}, {"matrix.dat", matrix.substr(2)}});
  EXPECT_NE(refusalOf(file).find("46 bytes"), std::string::npos);
  writeTar(file, {{"main.plist", "<plist><dict>"}, {"matrix.dat", matrix}});
  refusalOf(file);
}

// The shared NIfTI file was made from this project; Debian's package invesalius-examples installs it.
TEST(InVesalius, theExampleHeadAgreesWithItsNiftiCopyInTheWorld) {
  const std::filesystem::path example = "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";
  if (!std::filesystem::exists(example))
    GTEST_SKIP() << "needs Debian's package invesalius-examples";
  const auto head = readVolume(example);
  EXPECT_EQ(head->grid().dims, glm::ivec3(256, 256, 108));
  EXPECT_EQ(head->range(), (ValueRange{-1024.0, 2986.0}));
  EXPECT_EQ(head->info().unit, "HU");
  LIMN_NEEDS_SHARED("data/ct_head_cranium/ct_head_cranium.nii.gz");
  const auto copy = readVolume(sharedFolder() / "data/ct_head_cranium/ct_head_cranium.nii.gz");
  EXPECT_EQ(head->stored(), copy->stored());
  // The NIfTI header carries seven figures.
  for (const glm::dvec3& corner :
       {glm::dvec3(0.0), glm::dvec3(255.0, 0.0, 107.0), glm::dvec3(0.0, 255.0, 107.0)})
    expectNear(indexToWorld(head->grid(), corner), indexToWorld(copy->grid(), corner), 1e-4);
}

} // namespace
} // namespace limn
