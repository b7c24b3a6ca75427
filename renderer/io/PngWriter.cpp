// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/PngWriter.h"

#include "io/openimageio/PictureLibrary.h"

#include <png.h>

#include <cerrno>
#include <cmath>
#include <csetjmp>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <new>
#include <vector>

namespace limn {
namespace {

/// What libpng has written, and why it stopped. It leaves by jumping over frames, so that nothing that it
/// calls or that calls it may throw or own anything.
struct Encoded {
  std::vector<std::uint8_t> bytes;
  std::string problem;
  bool isOutOfMemory = false;
};

void keep(png_structp png, png_bytep data, std::size_t count) {
  auto& encoded = *static_cast<Encoded*>(png_get_io_ptr(png));
  try {
    encoded.bytes.insert(encoded.bytes.end(), data, data + count);
  } catch (const std::bad_alloc&) {
    encoded.isOutOfMemory = true;
  }
  if (encoded.isOutOfMemory)
    png_error(png, "memory");
}

[[noreturn]] void stop(png_structp png, png_const_charp reason) {
  try {
    static_cast<Encoded*>(png_get_error_ptr(png))->problem = reason;
  } catch (const std::bad_alloc&) {
    static_cast<Encoded*>(png_get_error_ptr(png))->isOutOfMemory = true;
  }
  png_longjmp(png, 1);
}

void ignore(png_structp /*png*/, png_const_charp /*warning*/) {}

void describe(png_structp png, png_infop info, const PictureToWrite& picture) {
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height),
               8, picture.hasAlpha ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_ABSOLUTE);
  if (picture.dotsPerInch > 0.0) {
    const auto dotsPerMetre = static_cast<png_uint_32>(std::lround(picture.dotsPerInch / 0.0254));
    png_set_pHYs(png, info, dotsPerMetre, dotsPerMetre, PNG_RESOLUTION_METER);
  }
  if (!picture.description.empty()) {
    png_text text{};
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    text.key = const_cast<char*>("Description"); // libpng copies both
    text.text = const_cast<char*>(picture.description.c_str());
    png_set_text(png, info, &text, 1);
  }
}

void writeAll(png_structp png, png_infop info, const PictureToWrite& picture) {
  describe(png, info, picture);
  png_write_info(png, info);
  const std::size_t stride = (picture.hasAlpha ? 4u : 3u) * static_cast<std::size_t>(picture.width);
  const auto* row = static_cast<const std::uint8_t*>(picture.pixels);
  for (int y = 0; y < picture.height; ++y, row += stride)
    png_write_row(png, row);
  png_write_end(png, info);
}

// Where libpng jumps back to, if anything fails.
bool writeOrStop(png_structp png, png_infop info, const PictureToWrite& picture) {
  if (setjmp(png_jmpbuf(png)) != 0)
    return false;
  writeAll(png, info, picture);
  return true;
}

Encoded encode(const PictureToWrite& picture) {
  Encoded encoded;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &encoded, stop, ignore);
  png_infop info = png ? png_create_info_struct(png) : nullptr;
  if (info) {
    png_set_write_fn(png, &encoded, keep, nullptr);
    if (!writeOrStop(png, info, picture) && encoded.problem.empty())
      encoded.isOutOfMemory = true;
  }
  encoded.isOutOfMemory = encoded.isOutOfMemory || !info;
  png_destroy_write_struct(&png, &info);
  if (encoded.isOutOfMemory)
    throw std::bad_alloc();
  return encoded;
}

std::string writeFile(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file)
    return std::strerror(errno);
  int problem = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() ? 0 : errno;
  if (std::fclose(file) != 0 && problem == 0)
    problem = errno;
  return problem == 0 ? std::string() : std::strerror(problem);
}

} // namespace

std::string writePng(const std::string& path, const PictureToWrite& picture) {
  const Encoded encoded = encode(picture);
  return encoded.problem.empty() ? writeFile(path, encoded.bytes) : encoded.problem;
}

} // namespace limn
