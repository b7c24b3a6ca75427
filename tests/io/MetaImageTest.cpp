// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/VolumeBytes.h"

namespace limn {
namespace {

using namespace test;

const std::string metaBasics =
    "ObjectType = Image\nNDims = 3\nBinaryData = True\nDimSize = 2 3 4\nElementType = "
    "MET_SHORT\nElementSpacing = 2 3 4\n";

std::shared_ptr<const Volume> openedMeta(const std::string& header, const std::string& bytes) {
  return openedAs("a.mha", header + "ElementDataFile = LOCAL\n" + bytes);
}

std::string refusedMeta(const std::string& header, const std::string& bytes) {
  return refusalAs("a.mha", header + "ElementDataFile = LOCAL\n" + bytes);
}

TEST(MetaImage, theTransformPlacesTheVoxelsInLps) {
  // Axis i along +y, j along -x, k along +z.
  const auto volume =
      openedMeta(metaBasics + "TransformMatrix = 0 1 0 -1 0 0 0 0 1\nOffset = 10 20 30\n", voxels());
  // Voxel (1, 2, 3): (10 - 2·3, 20 + 2, 30 + 3·4).
  expectNear(indexToWorld(volume->grid(), {1, 2, 3}), {4, 22, 42});
  EXPECT_EQ(volume->value({1, 2, 3}), 23.0);
  EXPECT_TRUE(volume->info().orientationKnown);
  EXPECT_TRUE(volume->info().warnings.empty());
}

TEST(MetaImage, withoutTransformTheOrientationIsUnknown) {
  EXPECT_FALSE(openedMeta(metaBasics, voxels())->info().orientationKnown);
  EXPECT_FALSE(
      openedMeta(metaBasics + "TransformMatrix = 1 0 0 0 1 0 0 0 1\nAnatomicalOrientation = ???\n", voxels())
          ->info()
          .orientationKnown);
}

TEST(MetaImage, everyEncodingHoldsTheSameVoxels) {
  const auto expected = openedMeta(metaBasics, voxels())->stored();
  EXPECT_EQ(openedMeta(metaBasics + "CompressedData = True\n", deflated(voxels(), false))->stored(),
            expected);
  EXPECT_EQ(
      openedMeta(metaBasics + "BinaryDataByteOrderMSB = True\n", bytesOf(rising<std::int16_t>(24), true))
          ->stored(),
      expected);
  EXPECT_EQ(openedMeta(metaBasics + "HeaderSize = 5\n", "12345" + voxels())->stored(), expected);
  EXPECT_EQ(openedMeta(metaBasics + "HeaderSize = -1\n", "1234567" + voxels())->stored(), expected);
}

TEST(MetaImage, coloursBecomeLuminanceAndOtherChannelsAreRefused) {
  std::string header = metaBasics;
  header.replace(header.find("2 3 4"), 5, "2 1 1");
  header.replace(header.find("MET_SHORT"), 9, "MET_UCHAR");
  const std::string colors = bytesOf<std::uint8_t>({255, 0, 0, 10, 20, 30});
  const auto volume = openedMeta(header + "ElementNumberOfChannels = 3\n", colors);
  EXPECT_EQ(volume->value({1, 0, 0}), 19.0); // 18.6 by BT.709
  EXPECT_TRUE(warns(*volume, "luminance"));
  refusedMeta(header + "ElementNumberOfChannels = 2\n", colors);
}

TEST(MetaImage, aShortFileAndImpossibleDimensionsAreRefused) {
  EXPECT_NE(refusedMeta(metaBasics, voxels().substr(1)).find("holds only"), std::string::npos);
  std::string header = metaBasics;
  header.replace(header.find("2 3 4"), 5, "2000000000 2000000000 2");
  refusedMeta(header, voxels());
  header = metaBasics;
  header.replace(header.find("2 3 4"), 5, "2 3 0");
  refusedMeta(header, voxels());
}

TEST(MetaImage, aMissingShortOrOutsideVoxelFileIsRefused) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "sub");
  const auto file = folder.path() / "sub" / "a.mhd";
  writeBytes(folder.path() / "b.raw", voxels());
  const auto refusedFor = [&](const std::string& name) {
    writeBytes(file, metaBasics + "ElementDataFile = " + name + "\n");
    try {
      readVolume(file);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("not refused");
  };
  EXPECT_NE(refusedFor("none.raw").find("none.raw is missing"), std::string::npos);
  EXPECT_NE(refusedFor("../b.raw").find("not in the folder"), std::string::npos);
  EXPECT_NE(refusedFor((folder.path() / "b.raw").string()).find("not in the folder"), std::string::npos);
  EXPECT_NE(refusedFor("LIST").find("several files"), std::string::npos);
  writeBytes(folder.path() / "sub" / "c.raw", voxels().substr(2));
  EXPECT_NE(refusedFor("c.raw").find("c.raw: its header asks for 48 bytes"), std::string::npos);
}

} // namespace
} // namespace limn
