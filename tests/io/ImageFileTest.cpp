// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ImageFile.h"

#include "scene/basics/Error.h"
#include "support/FileBytes.h"
#include "support/TemporaryFolder.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <random>
#include <regex>

namespace limn {
namespace {

using namespace test;

const std::string description = "{\"limn\":1,\"name\":\"a \\u00fc \\\"quoted\\\" scene\"}";

std::vector<float> samplesOf(const std::filesystem::path& file, int& channels) {
  const auto input = OIIO::ImageInput::open(file.string());
  channels = input->spec().nchannels;
  std::vector<float> samples(static_cast<std::size_t>(input->spec().width) *
                             static_cast<std::size_t>(input->spec().height) *
                             static_cast<std::size_t>(channels));
  input->read_image(0, 0, 0, channels, OIIO::TypeDesc::FLOAT, samples.data());
  return samples;
}

// An opaque red, a half-covering green and an empty pixel.
Image threePixels() {
  Image image({3, 1});
  image.at(0, 0) = {1.0f, 0.0f, 0.0f, 1.0f};
  image.at(1, 0) = {0.0f, 0.5f, 0.0f, 0.5f};
  image.at(2, 0) = {0.0f, 0.0f, 0.0f, 0.0f};
  return image;
}

TEST(ImageFile, eightBitPicturesLieOverTheBackground) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "a.tif"}) {
    writeImage(folder.path() / name, threePixels(), {0.2, 0.4, 1.0}, "");
    int channels = 0;
    const std::vector<float> samples = samplesOf(folder.path() / name, channels);
    ASSERT_EQ(channels, 3);
    // Levels: red over anything; (0, 0.5, 0) + 0.5·(0.2, 0.4, 1) = (0.1, 0.7, 0.5), rounded 25.5 → 26,
    // 178.5 → 179, 127.5 → 128; the background 51, 102, 255.
    const std::vector<int> expected = {255, 0, 0, 26, 179, 128, 51, 102, 255};
    for (std::size_t i = 0; i < expected.size(); ++i)
      EXPECT_EQ(std::lround(samples[i] * 255.0f), expected[i]) << name << " sample " << i;
  }
}

// Rows that suit one filter or another: flat, ramps along either axis and both, noise.
TEST(ImageFile, aPngIsReadBackToTheLastByteWithAlphaAndWithout) {
  const TemporaryFolder folder;
  std::mt19937 dice(1);
  for (const bool hasAlpha : {false, true}) {
    const int channels = hasAlpha ? 4 : 3;
    BytePicture picture{{301, 50}, hasAlpha, {}, 300.0};
    for (int y = 0; y < picture.size.y; ++y)
      for (int x = 0; x < picture.size.x; ++x)
        for (int c = 0; c < channels; ++c) {
          const std::array<unsigned, 5> kinds{7u, 3u * x + c, 5u * y + 60u * c, 2u * x + 3u * y,
                                              static_cast<unsigned>(dice() >> 8)};
          picture.bytes.push_back(static_cast<std::uint8_t>(kinds[static_cast<std::size_t>(y / 10)]));
        }
    const std::filesystem::path file = folder.path() / "a.png";
    writeBytes(file, picture, description);
    OIIO::ImageSpec wishes;
    wishes.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(file.string(), &wishes);
    ASSERT_TRUE(input);
    ASSERT_EQ(input->spec().nchannels, channels);
    std::vector<std::uint8_t> bytes(picture.bytes.size());
    ASSERT_TRUE(input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, bytes.data()));
    EXPECT_EQ(bytes, picture.bytes);
    EXPECT_EQ(input->spec().get_string_attribute("oiio:ColorSpace"), "sRGB");
  }
}

TEST(ImageFile, aPlainJpegIsCloseToItsColours) {
  const TemporaryFolder folder;
  Image image({16, 16});
  for (glm::vec4& pixel : image.pixels)
    pixel = {0.8f, 0.2f, 0.4f, 1.0f};
  writeImage(folder.path() / "a.jpg", image, glm::dvec3(0.0), "");
  int channels = 0;
  const std::vector<float> samples = samplesOf(folder.path() / "a.jpg", channels);
  // JPEG rounds to its own colour space and back: up to two levels.
  EXPECT_NEAR(samples[0], 0.8f, 2.5 / 255.0);
  EXPECT_NEAR(samples[1], 0.2f, 2.5 / 255.0);
  EXPECT_NEAR(samples[2], 0.4f, 2.5 / 255.0);
}

TEST(ImageFile, exrKeepsThePremultipliedFloats) {
  const TemporaryFolder folder;
  Image image = threePixels();
  image.at(2, 0) = {0.1234567f, 1e-7f, 2.5f, 0.25f};
  writeImage(folder.path() / "a.exr", image, {0.2, 0.4, 1.0}, "");
  int channels = 0;
  const std::vector<float> samples = samplesOf(folder.path() / "a.exr", channels);
  ASSERT_EQ(channels, 4);
  for (std::size_t i = 0; i < 12; ++i)
    EXPECT_EQ(samples[i], image.pixels[i / 4][static_cast<int>(i % 4)]) << i;
}

TEST(ImageFile, saysNowhereWhenItWasWritten) {
  const TemporaryFolder folder;
  // "2026:11:25 21:11:24", "2026-11-25": the same scene has to be the same bytes tomorrow.
  const std::regex date("(19|20)[0-9]{2}[:-][01][0-9][:-][0-3][0-9]");
  for (const char* name : {"a.png", "a.tif", "a.jpg", "a.exr"}) {
    writeImage(folder.path() / name, threePixels(), {0.2, 0.4, 1.0}, description);
    EXPECT_FALSE(std::regex_search(bytesOfFile(folder.path() / name), date)) << name;
  }
}

TEST(ImageFile, isWholeUpToItsLastChunk) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "a.exr"}) {
    const std::filesystem::path file = folder.path() / name;
    writeImage(file, threePixels(), {0.2, 0.4, 1.0}, description);
    EXPECT_TRUE(isWholePicture(file)) << name;
    EXPECT_FALSE(isWholePicture(folder.path() / "missing.png"));
    const std::string bytes = bytesOfFile(file);
    std::ofstream(file, std::ios::binary) << bytes.substr(0, bytes.size() - 12);
    EXPECT_FALSE(isWholePicture(file)) << name << " without its last 12 bytes";
  }
}

// It is read in several strips; the damage lies in the last of them.
TEST(ImageFile, isNotWholeWhereItsLastRowsAreDamaged) {
  const TemporaryFolder folder;
  Image image({512, 600});
  std::mt19937 random(3);
  for (glm::vec4& pixel : image.pixels)
    pixel = glm::vec4(static_cast<float>(random() % 256) / 255.0f);
  for (const char* name : {"a.png", "a.exr"}) {
    const std::filesystem::path file = folder.path() / name;
    writeImage(file, image, glm::dvec3(0.0), description);
    EXPECT_TRUE(isWholePicture(file)) << name;
    std::string bytes = bytesOfFile(file);
    std::fill_n(bytes.end() - static_cast<std::ptrdiff_t>(bytes.size() / 20), 100, '\xff');
    std::ofstream(file, std::ios::binary) << bytes;
    EXPECT_FALSE(isWholePicture(file)) << name;
  }
}

TEST(ImageFile, theDescriptionIsReadBack) {
  const TemporaryFolder folder;
  for (const char* name : {"a.png", "a.tif", "a.jpg", "a.exr"}) {
    writeImage(folder.path() / name, threePixels(), glm::dvec3(0.0), description);
    EXPECT_EQ(readImageDescription(folder.path() / name), description) << name;
    writeImage(folder.path() / name, threePixels(), glm::dvec3(0.0), "");
    EXPECT_EQ(readImageDescription(folder.path() / name), "") << name;
  }
}

TEST(ImageFile, aLongDescriptionIsReadBack) {
  const TemporaryFolder folder;
  const std::string text(40000, 'x');
  for (const char* name : {"a.png", "a.tif", "a.exr"}) {
    writeImage(folder.path() / name, threePixels(), glm::dvec3(0.0), text);
    EXPECT_EQ(readImageDescription(folder.path() / name), text) << name;
  }
}

TEST(ImageFile, aFailureThrowsAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  EXPECT_THROW(writeImage(folder.path() / "none" / "a.png", threePixels(), glm::dvec3(0.0), ""), Error);
  EXPECT_THROW(writeImage(folder.path() / "a.bmp", threePixels(), glm::dvec3(0.0), ""), Error);
  EXPECT_THROW(writeImage(folder.path() / "a.png", Image(), glm::dvec3(0.0), ""), Error);
  const std::string tooLong(70000, 'x');
  EXPECT_THROW(writeImage(folder.path() / "a.jpg", threePixels(), glm::dvec3(0.0), tooLong), Error);
  EXPECT_THROW(writeImage(folder.path() / "a.jpg", Image({70000, 1}), glm::dvec3(0.0), ""), Error);
  EXPECT_EQ(entriesOf(folder.path()), 0u);
}

TEST(ImageFile, anOldPictureIsReplacedAndOneThatIsNoneIsAnError) {
  const TemporaryFolder folder;
  writeBytes(folder.path() / "a.png", "no picture");
  EXPECT_THROW(readImageDescription(folder.path() / "a.png"), Error);
  writeImage(folder.path() / "a.png", threePixels(), glm::dvec3(0.0), description);
  EXPECT_EQ(readImageDescription(folder.path() / "a.png"), description);
  EXPECT_EQ(entriesOf(folder.path()), 1u);
}

} // namespace
} // namespace limn
