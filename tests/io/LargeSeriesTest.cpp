// SPDX-License-Identifier: GPL-3.0-or-later
// Slices that are larger than memory are decoded to the disk, and are the same volume.
#include "support/LargeSeries.h"
#include "io/VolumeReader.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace limn {
namespace {

namespace fs = std::filesystem;

class LargeSlices : public ::testing::Test {
protected:
  fs::path in(const char* name) const { return folder.path() / name; }

  static bool tellsOfDisk(const Message& warning) {
    return warning.english().starts_with("The voxels are kept on disk while the volume is open");
  }

  // So many bytes of them lie on the disk, and all else is as where they lie in memory.
  static void expectAlike(const fs::path& path, std::uint64_t onDisk) {
    ReadOptions little, much;
    little.memory = MemoryBudget(MemoryBudget::least);
    much.memory = MemoryBudget(3 * 4 * test::largeBytes);
    const auto kept = readVolume(path, little);
    const auto expected = readVolume(path, much);
    ASSERT_TRUE(kept->room());
    EXPECT_FALSE(expected->room());
    EXPECT_EQ(kept->room()->taken(), onDisk);
    EXPECT_TRUE(kept->stored() == expected->stored());
    EXPECT_EQ(kept->grid(), expected->grid());
    EXPECT_EQ(kept->rescale(), expected->rescale());
    EXPECT_EQ(kept->range().lowest, expected->range().lowest);
    EXPECT_EQ(kept->range().highest, expected->range().highest);
    EXPECT_EQ(kept->invalidVoxels(), expected->invalidVoxels());
    for (std::size_t i = 0; expected->invalidVoxels() > 0 && i < expected->voxelCount(); ++i)
      ASSERT_EQ(kept->invalidMask()[i], expected->invalidMask()[i]) << i;
    std::vector<Message> warnings = kept->info().warnings;
    EXPECT_EQ(std::erase_if(warnings, tellsOfDisk), 1u) << "what is kept on disk is said once";
    EXPECT_EQ(warnings, expected->info().warnings);
  }

  test::TemporaryFolder folder;
};

TEST_F(LargeSlices, ofDicomAreDecodedToDisk) {
  test::writeLargeSeries(in("series"));
  expectAlike(in("series"), test::largeBytes);
}

// Each slice then counts in floats.
TEST_F(LargeSlices, withARescaleEachAreDecodedToDisk) {
  test::writeLargeSeries(in("series"), {.hasRescales = true});
  expectAlike(in("series"), 2 * test::largeBytes);
}

// 170 slices, each half a millimetre further: 85 rows more; what no slice covers is padding, in a mask of a
// bit each.
TEST_F(LargeSlices, thatAreShearedAreStraightenedOnDisk) {
  test::writeLargeSeries(in("series"), {.shearMm = 0.5});
  ReadOptions little;
  little.memory = MemoryBudget(MemoryBudget::least);
  const glm::ivec3 dims = readVolume(in("series"), little)->grid().dims;
  const auto voxels = static_cast<std::uint64_t>(dims.x) * dims.y * dims.z;
  EXPECT_GT(dims.y, test::largeSide + 80);
  expectAlike(in("series"), voxels * sizeof(std::int16_t) + (voxels + 63) / 64 * 8);
}

TEST_F(LargeSlices, ofPicturesAreDecodedToDisk) {
  ASSERT_TRUE(test::writeLargeStack(in("stack")));
  expectAlike(in("stack"), test::largeBytes);
  ASSERT_TRUE(test::writeLargeStack(in("pages.tif")));
  expectAlike(in("pages.tif"), test::largeBytes);
}

} // namespace
} // namespace limn
