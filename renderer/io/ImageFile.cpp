// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ImageFile.h"

#include "io/AtomicFile.h"
#include "io/PdfDescription.h"
#include "io/PngWriter.h"
#include "io/openimageio/PictureLibrary.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <string_view>

namespace limn {
namespace {

namespace fs = std::filesystem;

using Format = PictureToWrite::Format;

Format formatOf(const fs::path& path) {
  const std::string ending = lowerCase(path.extension().string());
  if (ending == ".png")
    return Format::png;
  if (ending == ".tif" || ending == ".tiff")
    return Format::tiff;
  if (ending == ".jpg" || ending == ".jpeg")
    return Format::jpeg;
  if (ending == ".exr")
    return Format::exr;
  throw Error(
      Error::Kind::usage,
      Message::tr("Cannot write %1: its ending names no picture format; use .png, .tif, .jpg or .exr.")
          .arg(path.string()));
}

// Rounds to the nearest of 256 levels.
std::uint8_t level(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255.0));
}

void writeAtomically(const fs::path& path, const PictureToWrite& picture) {
  replaceAtomically(path, [&](const fs::path& temporary) {
    const std::string file = temporary.string();
    const std::string problem =
        picture.format == Format::png ? writePng(file, picture) : pictureLibrary().write(file, picture);
    if (!problem.empty())
      throw Error(Error::Kind::other,
                  Message::tr("Cannot write %1: %2; choose another folder, ending or size.")
                      .arg(path.string(), problem));
  });
}

// libjpeg ends the whole program where a picture or a comment is beyond what the format can hold.
void requireJpegCanHold(const fs::path& path, const glm::ivec2& size, const std::string& description) {
  constexpr int longestSide = 65500;
  constexpr std::size_t longestComment = 60000;
  if (size.x > longestSide || size.y > longestSide || description.size() > longestComment)
    throw Error(
        Error::Kind::usage,
        Message::tr("Cannot write %1: the picture or its description is too large for JPEG; use .png.")
            .arg(path.string()));
}

// The floats of both, of each pixel together: RGBA, and what of the radiance is colour.
std::vector<float> sideBySideInPixels(const Image& image, const Image& radiance) {
  std::vector<float> floats;
  floats.reserve(image.pixels.size() * 7);
  for (std::size_t n = 0; n < image.pixels.size(); ++n) {
    const glm::vec4& pixel = image.pixels[n];
    const glm::vec4& light = radiance.pixels[n];
    floats.insert(floats.end(), {pixel.r, pixel.g, pixel.b, pixel.a, light.r, light.g, light.b});
  }
  return floats;
}

// A PNG ends with a chunk of its own, which no reader of rows misses.
bool hasEnd(const fs::path& path) {
  constexpr std::string_view begin = "\x89PNG", end("\0\0\0\0IEND\xAE\x42\x60\x82", 12);
  std::ifstream file(path, std::ios::binary);
  std::string bytes(begin.size(), '\0');
  if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) || bytes != begin)
    return true; // another format
  bytes.resize(end.size());
  file.seekg(-static_cast<std::streamoff>(end.size()), std::ios::end);
  return file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) && bytes == end;
}

} // namespace

void requirePictureEnding(const fs::path& path) {
  formatOf(path);
}

BytePicture bytesOverBackground(const Image& image, const glm::dvec3& background) {
  BytePicture picture;
  picture.size = image.size;
  picture.bytes.reserve(image.pixels.size() * 3);
  for (const glm::vec4& pixel : image.pixels)
    for (int c = 0; c < 3; ++c)
      picture.bytes.push_back(
          level(static_cast<double>(pixel[c]) + (1.0 - static_cast<double>(pixel.a)) * background[c]));
  return picture;
}

void writeImage(const fs::path& path, const Image& image, const glm::dvec3& background,
                const std::string& description, const Image& radiance) {
  const Format format = formatOf(path);
  if (image.size.x < 1 || image.size.y < 1)
    throw Error(Error::Kind::usage,
                Message::tr("Cannot write %1: the picture has no pixels.").arg(path.string()));
  if (format == Format::jpeg)
    requireJpegCanHold(path, image.size, description);
  const std::vector<std::uint8_t> levels =
      format == Format::exr ? std::vector<std::uint8_t>() : bytesOverBackground(image, background).bytes;
  const bool hasRadiance = format == Format::exr && radiance.size == image.size;
  const std::vector<float> layers = hasRadiance ? sideBySideInPixels(image, radiance) : std::vector<float>();
  const void* pixels = hasRadiance             ? static_cast<const void*>(layers.data())
                       : format == Format::exr ? static_cast<const void*>(image.pixels.data())
                                               : levels.data();
  writeAtomically(path, {format, image.size.x, image.size.y, pixels, description, false, 0.0, hasRadiance});
}

void writeBytes(const fs::path& path, const BytePicture& picture, const std::string& description) {
  const Format format = formatOf(path);
  if (format != Format::png && format != Format::tiff)
    throw Error(
        Error::Kind::usage,
        Message::tr("Cannot write %1: this picture needs the ending .png or .tif.").arg(path.string()));
  writeAtomically(path, {format, picture.size.x, picture.size.y, picture.bytes.data(), description,
                         picture.hasAlpha, picture.dotsPerInch});
}

namespace {

StoredPicture openedPicture(const fs::path& path) {
  std::optional<StoredPicture> picture = pictureLibrary().open(path.string());
  if (!picture) {
    std::error_code problem;
    const bool isThere = fs::exists(path, problem);
    const bool isEmpty = isThere && fs::file_size(path, problem) == 0 && !problem;
    const Message reason = !isThere  ? Message::tr("there is no such file")
                           : isEmpty ? Message::tr("the file is empty")
                                     : Message::tr("it is no picture, or a damaged one");
    failReading(path, reason, Message::tr("choose a PNG, TIFF, JPEG or EXR picture"));
  }
  return std::move(*picture);
}

} // namespace

std::string readImageDescription(const fs::path& path) {
  return isPdf(path) ? readPdfDescription(path) : openedPicture(path).description;
}

std::optional<glm::ivec2> readImageSize(const fs::path& path) {
  if (isPdf(path))
    return std::nullopt;
  const StoredPicture picture = openedPicture(path);
  return glm::ivec2(picture.width, picture.height);
}

BytePicture readBytes(const fs::path& path) {
  const std::optional<StoredPicture> stored = pictureLibrary().open(path.string());
  if (stored && stored->sample == StoredPicture::Sample::uint8 && stored->channels >= 3) {
    BytePicture picture;
    picture.size = {stored->width, stored->height};
    const auto channels = static_cast<std::size_t>(stored->channels);
    std::vector<std::uint8_t> samples(channels * picture.size.x * picture.size.y);
    if (stored->readRows(samples.data(), 0, picture.size.y)) {
      for (std::size_t i = 0; i < samples.size(); i += channels)
        picture.bytes.insert(picture.bytes.end(), &samples[i], &samples[i] + 3);
      return picture;
    }
  }
  failReading(path, Message::tr("it is no picture, or a damaged one"), Message::tr("draw it anew"));
}

Image readExr(const fs::path& path, ExrLayer layer) {
  const std::optional<StoredPicture> picture = pictureLibrary().open(path.string());
  const bool hasRadiance = picture && picture->channels == 7;
  const bool hasLayer = picture && (hasRadiance || (picture->channels == 4 && layer == ExrLayer::picture));
  if (hasLayer && picture->sample == StoredPicture::Sample::float32) {
    Image image({picture->width, picture->height});
    const auto channels = static_cast<std::size_t>(picture->channels);
    std::vector<float> floats(channels * image.pixels.size());
    if (picture->readRows(floats.data(), 0, picture->height)) {
      const std::size_t first = layer == ExrLayer::radiance ? 4 : 0;
      for (std::size_t n = 0; n < image.pixels.size(); ++n) {
        const float* pixel = &floats[channels * n];
        image.pixels[n] = {pixel[first], pixel[first + 1], pixel[first + 2], pixel[3]};
      }
      return image;
    }
  }
  failReading(path, Message::tr("it is no picture, or a damaged one"), Message::tr("draw it anew"));
}

bool isWholePicture(const fs::path& path) {
  std::error_code unknown;
  if (!fs::is_regular_file(path, unknown) || !hasEnd(path))
    return false;
  const std::optional<StoredPicture> picture = pictureLibrary().open(path.string());
  if (!picture)
    return false;
  // Some MiB at a time, for the library takes tens of MiB of its own for each call.
  constexpr std::size_t widestSample = sizeof(double), stripBytes = std::size_t{4} << 20;
  const std::size_t rowBytes = static_cast<std::size_t>(picture->width) * picture->channels * widestSample;
  const int rows =
      static_cast<int>(std::max<std::size_t>(stripBytes / std::max<std::size_t>(rowBytes, 1), 1));
  std::vector<std::uint8_t> strip(std::min(rows, picture->height) * rowBytes);
  for (int y = 0; y < picture->height; y += rows)
    if (!picture->readRows(strip.data(), y, std::min(rows, picture->height - y)))
      return false;
  return true;
}

} // namespace limn
