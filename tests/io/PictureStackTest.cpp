// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/PictureStack.h"
#include "io/ImageFile.h"
#include "io/VolumeBytes.h"

namespace limn {
namespace {

using namespace test;

// A grey 3 x 2 picture whose top left pixel is `level` of 255 and whose others are 0.
void writeSlice(const std::filesystem::path& file, int level, const glm::ivec2& size = {3, 2}) {
  Image image(size);
  for (glm::vec4& pixel : image.pixels)
    pixel = {0.0f, 0.0f, 0.0f, 1.0f};
  image.at(0, 0) = glm::vec4(glm::vec3(static_cast<float>(level) / 255.0f), 1.0f);
  writeImage(file, image, glm::dvec3(0.0), "");
}

TEST(PictureStack, namesAreOrderedByTheirNumbers) {
  EXPECT_TRUE(naturalLess("slice2.png", "slice10.png"));
  EXPECT_FALSE(naturalLess("slice10.png", "slice2.png"));
  EXPECT_TRUE(naturalLess("slice002.png", "slice10.png"));
  EXPECT_TRUE(naturalLess("a9b1.png", "a9b2.png"));
  EXPECT_TRUE(naturalLess("a.png", "b.png"));
  EXPECT_TRUE(naturalLess("a99999999999999999999999.png", "a100000000000000000000000.png"));
  EXPECT_FALSE(naturalLess("a.png", "a.png"));
}

TEST(PictureStack, aFolderIsAVolumeOfUnknownSpacingAndOrientation) {
  const TemporaryFolder folder;
  for (int i = 1; i <= 12; ++i)
    writeSlice(folder.path() / ("slice" + std::to_string(i) + ".png"), 10 * i);
  writeBytes(folder.path() / "notes.txt", "not a picture");
  const auto volume = readVolume(folder.path());
  EXPECT_EQ(volume->grid().dims, glm::ivec3(3, 2, 12));
  EXPECT_EQ(voxelTypeName(volume->stored()), "uint8");
  for (int k = 0; k < 12; ++k)
    EXPECT_EQ(volume->value({0, 0, k}), 10.0 * (k + 1));
  EXPECT_EQ(volume->value({0, 1, 3}), 0.0);
  EXPECT_FALSE(volume->info().spacingKnown);
  EXPECT_FALSE(volume->info().orientationKnown);
  EXPECT_TRUE(warns(*volume, "Spacing unknown"));
  EXPECT_TRUE(warns(*volume, "luminance"));
}

TEST(PictureStack, theSpacingCanBeGiven) {
  const TemporaryFolder folder;
  writeSlice(folder.path() / "1.png", 1);
  writeSlice(folder.path() / "2.png", 2);
  ReadOptions options;
  options.spacingMm = glm::dvec3(0.5, 0.5, 2.0);
  const auto volume = readVolume(folder.path(), options);
  expectNear(volume->grid().spacingMm, {0.5, 0.5, 2.0});
  EXPECT_TRUE(volume->info().spacingKnown);
  EXPECT_FALSE(warns(*volume, "Spacing unknown"));
  options.spacingMm = glm::dvec3(0.5, -0.5, 2.0);
  EXPECT_THROW(readVolume(folder.path(), options), Error);
}

TEST(PictureStack, aGapInTheNumbersAndLossyPicturesAreSaid) {
  const TemporaryFolder folder;
  for (const int i : {1, 2, 4})
    writeSlice(folder.path() / ("s" + std::to_string(i) + ".jpg"), 10 * i);
  const auto volume = readVolume(folder.path());
  EXPECT_TRUE(warns(*volume, "slices may be missing"));
  EXPECT_TRUE(warns(*volume, "lossy"));
}

TEST(PictureStack, picturesThatDoNotMatchAreRefused) {
  const TemporaryFolder folder;
  writeSlice(folder.path() / "1.png", 1);
  EXPECT_NE(refusalOf(folder.path() / "1.png").find("single picture"), std::string::npos);
  writeSlice(folder.path() / "2.png", 2, {4, 2});
  EXPECT_NE(refusalOf(folder.path()).find("2.png"), std::string::npos);
  writeSlice(folder.path() / "2.png", 2);
  writeSlice(folder.path() / "3.tif", 3);
  EXPECT_NE(refusalOf(folder.path()).find("several kinds"), std::string::npos);
}

TEST(PictureStack, aDamagedPictureIsRefused) {
  const TemporaryFolder folder;
  writeSlice(folder.path() / "1.png", 1);
  writeSlice(folder.path() / "2.png", 2);
  const std::string bytes = bytesOfFile(folder.path() / "2.png");
  writeBytes(folder.path() / "2.png", bytes.substr(0, bytes.size() / 2));
  EXPECT_NE(refusalOf(folder.path() / "2.png").find("2.png"), std::string::npos);
}

} // namespace
} // namespace limn
