// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ImageFile.h"

#include "io/AtomicFile.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace limn {
namespace {

namespace fs = std::filesystem;

enum class Kind { png, tiff, jpeg, exr };

Kind kindOf(const fs::path& path) {
  const std::string ending = lowerCase(path.extension().string());
  if (ending == ".png")
    return Kind::png;
  if (ending == ".tif" || ending == ".tiff")
    return Kind::tiff;
  if (ending == ".jpg" || ending == ".jpeg")
    return Kind::jpeg;
  if (ending == ".exr")
    return Kind::exr;
  throw Error(Error::Kind::usage, "Cannot write " + path.string() +
                                      ": its ending names no picture format; use .png, .tif, .jpg or .exr.");
}

// Rounds to the nearest of 256 levels.
std::uint8_t level(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255.0));
}

// Lays the premultiplied pixels over the background.
std::vector<std::uint8_t> composited(const Image& image, const glm::dvec3& background) {
  std::vector<std::uint8_t> levels;
  levels.reserve(image.pixels.size() * 3);
  for (const glm::vec4& pixel : image.pixels)
    for (int c = 0; c < 3; ++c)
      levels.push_back(
          level(static_cast<double>(pixel[c]) + (1.0 - static_cast<double>(pixel.a)) * background[c]));
  return levels;
}

OIIO::ImageSpec specOf(Kind kind, const glm::ivec2& size, const std::string& description) {
  const bool isFloat = kind == Kind::exr;
  OIIO::ImageSpec spec(size.x, size.y, isFloat ? 4 : 3,
                       isFloat ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
  if (isFloat)
    spec.alpha_channel = 3;
  else
    spec.attribute("oiio:ColorSpace", "sRGB");
  if (kind == Kind::jpeg) {
    spec.attribute("CompressionQuality", 95);
    spec.attribute("jpeg:subsampling", "4:4:4");
  }
  if (kind == Kind::tiff)
    spec.attribute("compression", "zip");
  if (!description.empty())
    spec.attribute("ImageDescription", description);
  return spec;
}

// libjpeg ends the whole program where a picture or a comment is beyond what the format can hold.
void requireJpegCanHold(const fs::path& path, const glm::ivec2& size, const std::string& description) {
  constexpr int longestSide = 65500;
  constexpr std::size_t longestComment = 60000;
  if (size.x > longestSide || size.y > longestSide || description.size() > longestComment)
    throw Error(Error::Kind::usage, "Cannot write " + path.string() +
                                        ": the picture or its description is too large for JPEG; use .png.");
}

void writePixels(const fs::path& temporary, const fs::path& target, const OIIO::ImageSpec& spec,
                 const void* pixels) {
  const auto output = OIIO::ImageOutput::create(temporary.string());
  const bool isWritten = output && output->open(temporary.string(), spec) &&
                         output->write_image(spec.format, pixels) && output->close();
  if (!isWritten)
    throw Error(Error::Kind::other, "Cannot write " + target.string() + ": " +
                                        (output ? output->geterror() : OIIO::geterror()) +
                                        "; choose another folder, ending or size.");
}

} // namespace

void writeImage(const fs::path& path, const Image& image, const glm::dvec3& background,
                const std::string& description) {
  const Kind kind = kindOf(path);
  if (image.size.x < 1 || image.size.y < 1)
    throw Error(Error::Kind::usage, "Cannot write " + path.string() + ": the picture has no pixels.");
  if (kind == Kind::jpeg)
    requireJpegCanHold(path, image.size, description);
  const OIIO::ImageSpec spec = specOf(kind, image.size, description);
  const std::vector<std::uint8_t> levels =
      kind == Kind::exr ? std::vector<std::uint8_t>() : composited(image, background);
  const void* pixels = kind == Kind::exr ? static_cast<const void*>(image.pixels.data()) : levels.data();
  replaceAtomically(path, [&](const fs::path& temporary) { writePixels(temporary, path, spec, pixels); });
}

std::string readImageDescription(const fs::path& path) {
  const auto input = OIIO::ImageInput::open(path.string());
  if (!input) {
    OIIO::geterror(); // the library's words, which it would print at the end
    std::error_code problem;
    const bool isThere = fs::exists(path, problem);
    const bool isEmpty = isThere && fs::file_size(path, problem) == 0 && !problem;
    const char* reason = !isThere  ? "there is no such file"
                         : isEmpty ? "the file is empty"
                                   : "it is no picture, or a damaged one";
    failReading(path, reason, "choose a PNG, TIFF, JPEG or EXR picture");
  }
  return input->spec().get_string_attribute("ImageDescription");
}

} // namespace limn
