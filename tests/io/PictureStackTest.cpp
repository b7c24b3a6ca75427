// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/pictures/PictureStack.h"

#include "io/ImageFile.h"
#include "io/VolumeBytes.h"
#include <OpenImageIO/imageio.h>

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
  for (const char* name : {"s1.jpg", "s2.jpg", "s4.jpg"})
    writeSlice(folder.path() / name, 10);
  const auto volume = readVolume(folder.path());
  EXPECT_TRUE(warns(*volume, "slices may be missing"));
  EXPECT_TRUE(warns(*volume, "lossy"));
}

TEST(PictureStack, aSliceThatIsEmptyOrCutOffIsRefusedAndNamed) {
  for (const char* lost : {"engine_0005.png", "engine_0010.png"}) {
    const TemporaryFolder folder;
    for (int i = 1; i <= 10; ++i)
      writeSlice(folder.path() / ("engine_00" + std::string(i < 10 ? "0" : "") + std::to_string(i) + ".png"),
                 i);
    const std::string bytes = bytesOfFile(folder.path() / lost);
    for (const std::size_t size : {std::size_t{0}, std::size_t{5}, std::size_t{20}, bytes.size() - 30}) {
      writeBytes(folder.path() / lost, bytes.substr(0, size));
      const std::string refusal = refusalOf(folder.path());
      EXPECT_NE(refusal.find((folder.path() / lost).string()), std::string::npos) << size << ": " << refusal;
      // None of the words of the library that decodes.
      EXPECT_EQ(refusal.find("PNG "), std::string::npos) << refusal;
      EXPECT_EQ(refusal.find('?'), std::string::npos) << refusal;
    }
    writeBytes(folder.path() / lost, bytes);
    for (const char* foreign : {".engine_0004.png", "Thumbs.db", "engine_0004.txt"})
      writeBytes(folder.path() / foreign, "");
    EXPECT_EQ(readVolume(folder.path())->grid().dims.z, 10);
  }
}

TEST(PictureStack, anEmptyPictureIsCalledEmpty) {
  const TemporaryFolder folder;
  writeBytes(folder.path() / "empty.png", "");
  EXPECT_NE(refusalOf(folder.path() / "empty.png").find("the file is empty"), std::string::npos);
  try {
    readImageDescription(folder.path() / "empty.png");
    ADD_FAILURE() << "read an empty picture";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("the file is empty"), std::string::npos) << error.what();
  }
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

// A TIFF of three pages of 4 x 2 floats: page and pixel number, p + 0.25 i.
void writePages(const std::filesystem::path& file) {
  const auto output = OIIO::ImageOutput::create(file.string());
  const OIIO::ImageSpec spec(4, 2, 1, OIIO::TypeDesc::FLOAT);
  for (int page = 0; page < 3; ++page) {
    std::vector<float> samples;
    for (int i = 0; i < 8; ++i)
      samples.push_back(static_cast<float>(page) + 0.25f * static_cast<float>(i));
    output->open(file.string(), spec,
                 page == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendSubimage);
    output->write_image(OIIO::TypeDesc::FLOAT, samples.data());
  }
  output->close();
}

TEST(PictureStack, thePagesOfATiffAreSlicesInTheirOwnType) {
  const TemporaryFolder folder;
  writePages(folder.path() / "a.tif");
  const auto volume = readVolume(folder.path() / "a.tif");
  EXPECT_EQ(volume->grid().dims, glm::ivec3(4, 2, 3));
  EXPECT_EQ(voxelTypeName(volume->stored()), "float32");
  // Row 1, column 2 is pixel 6.
  EXPECT_EQ(volume->value({2, 1, 2}), 3.5);
}

// Two pages of 37 x 23 pixels whose sample c of pixel i is (5 i + 40 c + page) mod 200, in the layout of
// `spec`.
std::shared_ptr<const Volume> written(OIIO::ImageSpec spec) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.tif";
  const auto output = OIIO::ImageOutput::create(file.string());
  for (int page = 0; page < 2; ++page) {
    std::vector<float> samples;
    for (int i = 0; i < spec.width * spec.height; ++i)
      for (int c = 0; c < spec.nchannels; ++c)
        samples.push_back(static_cast<float>((5 * i + 40 * c + page) % 200) / 255.0f);
    output->open(file.string(), spec,
                 page == 0 ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendSubimage);
    output->write_image(OIIO::TypeDesc::FLOAT, samples.data());
  }
  output->close();
  return readVolume(file);
}

TEST(PictureStack, stripsTilesAndPlanesHoldTheSamePixels) {
  for (const int channels : {1, 3, 4}) {
    const OIIO::ImageSpec strips(37, 23, channels, OIIO::TypeDesc::UINT8);
    const auto expected = written(strips);
    EXPECT_EQ(expected->grid().dims, glm::ivec3(37, 23, 2));
    if (channels == 1)
      EXPECT_EQ(expected->value({3, 1, 1}), (5 * (37 + 3) + 1) % 200);
    else // pixel 3: 15, 55 and 95; 0.2126 · 15 + 0.7152 · 55 + 0.0722 · 95 = 49.4
      EXPECT_EQ(expected->value({3, 0, 0}), 49.0);
    for (const bool isTiled : {false, true})
      for (const char* planes : {"contig", "separate"})
        for (const char* packing : {"none", "zip", "lzw", "packbits"}) {
          OIIO::ImageSpec spec = strips;
          spec.attribute("planarconfig", planes);
          spec.attribute("compression", packing);
          spec.tile_width = spec.tile_height = isTiled ? 16 : 0;
          EXPECT_TRUE(written(spec)->stored() == expected->stored())
              << channels << " " << isTiled << " " << planes << " " << packing;
        }
  }
}

TEST(PictureStack, wideAndRealSamplesKeepTheirValues) {
  // Pixel 40 of page 1 is 201 mod 200 = 1 of 255: 257 of 65535, 1/255 as a real number.
  EXPECT_EQ(written({37, 23, 1, OIIO::TypeDesc::UINT16})->value({3, 1, 1}), 257.0);
  EXPECT_EQ(written({37, 23, 1, OIIO::TypeDesc::FLOAT})->value({3, 1, 1}),
            static_cast<double>(1.0f / 255.0f));
  // A half has eleven bits.
  const auto halves = written({37, 23, 1, OIIO::TypeDesc::HALF});
  EXPECT_EQ(voxelTypeName(halves->stored()), "float32");
  EXPECT_NEAR(halves->value({3, 1, 1}), 1.0 / 255.0, std::ldexp(1.0 / 255.0, -11));
}

// A cut may fall behind the last pixel, into tags that do not matter; then all voxels must be there.
TEST(PictureStack, aTiffThatEndsEarlyIsRefusedNotShortened) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.tif";
  writePages(file);
  const std::string bytes = bytesOfFile(file);
  const auto whole = readVolume(file);
  std::size_t refused = 0, cuts = 0;
  for (std::size_t size = 8; size < bytes.size(); size += 13, ++cuts) {
    writeBytes(file, bytes.substr(0, size));
    try {
      EXPECT_EQ(readVolume(file)->stored(), whole->stored()) << "cut to " << size;
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, cuts * 3 / 4);
}

// A grey ramp with a pattern, so that no part of the compressed picture is without effect.
void writePattern(const std::filesystem::path& file) {
  Image image({48, 40});
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 48; ++x)
      image.at(x, y) = glm::vec4(glm::vec3(static_cast<float>((x * 7 + y * 13) % 64) / 64.0f), 1.0f);
  writeImage(file, image, glm::dvec3(0.0), "");
}

TEST(PictureStack, aPictureThatEndsEarlyIsRefusedNotFilledUp) {
  for (const char* ending : {".png", ".jpg", ".tif"}) {
    const TemporaryFolder folder;
    const auto first = folder.path() / ("1" + std::string(ending));
    const auto second = folder.path() / ("2" + std::string(ending));
    writePattern(first);
    writePattern(second);
    const auto whole = readVolume(folder.path());
    const std::string bytes = bytesOfFile(second);
    std::size_t refused = 0, cuts = 0;
    for (std::size_t size = 16; size < bytes.size(); size += 29, ++cuts) {
      writeBytes(second, bytes.substr(0, size));
      try {
        EXPECT_TRUE(readVolume(folder.path())->stored() == whole->stored()) << ending << " cut to " << size;
      } catch (const Error&) {
        ++refused;
      }
    }
    EXPECT_GT(refused, cuts * 3 / 4) << ending;
  }
}

} // namespace
} // namespace limn
