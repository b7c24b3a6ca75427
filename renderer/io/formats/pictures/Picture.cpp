// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/formats/pictures/Picture.h"

#include "io/openimageio/PictureLibrary.h"
#include "io/reading/ReadError.h"

#include <fstream>
#include <iterator>
#include <optional>

namespace limn {
namespace {

namespace fs = std::filesystem;

// The library keeps the segments before a picture in a list and walks it for each.
constexpr int mostSegments = 4096;
// Pixels come in chunks of 8 KiB and more.
constexpr int mostChunks = 1 << 20;

[[noreturn]] void failDamagedPicture(const fs::path& file) {
  failReading(file, Message::tr("the picture is damaged or cut off"), copyAgain);
}

VoxelType typeOfSample(const fs::path& file, StoredPicture::Sample stored) {
  switch (stored) {
  case StoredPicture::Sample::uint8:
    return VoxelType::uint8;
  case StoredPicture::Sample::uint16:
    return VoxelType::uint16;
  case StoredPicture::Sample::float32:
  case StoredPicture::Sample::other:
    break;
  }
  failReading(file, Message::tr("its samples are of a type that is not supported"),
              Message::tr("convert it to 8 or 16 bits first"));
}

// Walks the segments of a JPEG file up to its pixels. Throws where there are more than any camera writes, or
// no mark of the end follows: the decoder fills what is missing with grey.
void requireSoundJpeg(const fs::path& file) {
  using namespace std::string_view_literals;
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(2);
  for (int segments = 0;; ++segments) {
    int mark = stream.get();
    while (mark == 0xff)
      mark = stream.get();
    const int high = stream.get();
    const int low = stream.get();
    if (!stream || segments > mostSegments)
      failDamagedPicture(file);
    if (mark == 0xda)
      break;
    stream.seekg((high << 8 | low) - 2, std::ios::cur);
    if (stream.get() != 0xff)
      failDamagedPicture(file);
  }
  constexpr std::streamoff tailBytes = 4096;
  stream.clear();
  stream.seekg(0, std::ios::end);
  stream.seekg(std::max<std::streamoff>(0, static_cast<std::streamoff>(stream.tellg()) - tailBytes));
  const std::string tail{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (tail.rfind("\xff\xd9"sv) == std::string::npos)
    failReading(file, Message::tr("the picture is cut off"), copyAgain);
}

// Walks the chunks of a PNG file to its end, so that a picture that is cut off never reaches the decoder,
// which prints its own complaints.
void requireWholePng(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  stream.seekg(8);
  std::string head(8, '\0');
  for (int chunks = 0; chunks < mostChunks && stream.read(head.data(), 8); ++chunks) {
    if (head.ends_with("IEND"))
      return;
    std::uint32_t length = 0;
    for (int i = 0; i < 4; ++i)
      length = length << 8 | static_cast<unsigned char>(head[static_cast<std::size_t>(i)]);
    stream.seekg(static_cast<std::streamoff>(length) + 4, std::ios::cur);
  }
  failReading(file, Message::tr("the picture is cut off"), copyAgain);
}

bool isJpeg(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return stream.get() == 0xff;
}

} // namespace

void requireRoom(const fs::path& file, const PictureShape& shape) {
  // The best compression that the formats know is deflate's, 1032 to 1, of pixels of one bit.
  constexpr std::uint64_t largestRatio = 8 * 1032;
  const bool hasPixels = shape.width >= 1 && shape.height >= 1 && shape.channels >= 1;
  if (!hasPixels ||
      rowBytes(shape) * static_cast<std::uint64_t>(shape.height) / largestRatio > fs::file_size(file))
    failReading(file, Message::tr("its header asks for more pixels than the file can hold"), copyAgain);
}

Picture openPicture(const fs::path& file) {
  if (isJpeg(file))
    requireSoundJpeg(file);
  else
    requireWholePng(file);
  const std::optional<StoredPicture> stored = pictureLibrary().open(file.string());
  if (!stored)
    failDamagedPicture(file);
  Picture picture;
  picture.shape = {stored->width, stored->height, stored->channels, typeOfSample(file, stored->sample)};
  requireRoom(file, picture.shape);
  picture.readRows = [read = stored->readRows, file](unsigned char* to, int first, int count) {
    if (!read(to, first, count))
      failDamagedPicture(file);
  };
  return picture;
}

} // namespace limn
