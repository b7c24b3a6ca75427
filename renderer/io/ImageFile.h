// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Image.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// Throws Error (usage) where the extension names no format that writeImage knows.
void requirePictureEnding(const std::filesystem::path& path);

/// Writes a picture by its extension: PNG, TIFF and JPEG as 8 bits composited over `background` (0..1), EXR
/// as premultiplied float RGBA without it; of `radiance`, which may be empty and else has the picture's size,
/// the colours go beside them, in channels radiance.R, .G and .B. `description` (ASCII, may be empty) goes
/// into the image description. Atomic: the file is complete or untouched. Throws Error, also where JPEG
/// cannot hold the size (65,500 pixels a side) or the description (60,000 bytes).
void writeImage(const std::filesystem::path& path, const Image& image, const glm::dvec3& background,
                const std::string& description, const Image& radiance = {});

/// A picture whose bytes are made: 8 bits a channel, row by row from the top.
struct BytePicture {
  glm::ivec2 size{0};
  bool hasAlpha = false;           ///< RGBA, the colours not multiplied by alpha; otherwise RGB
  std::vector<std::uint8_t> bytes; ///< size.x · size.y · (4 or 3)
  double dotsPerInch = 0.0;        ///< at which it is meant to be printed; 0: nothing is said
};

/// A picture of 8 bits as it is seen: composited over `background` (0..1), RGB, each value rounded.
BytePicture bytesOverBackground(const Image& image, const glm::dvec3& background);

/// Writes such a picture as PNG or TIFF by its extension, as writeImage does. Throws Error.
void writeBytes(const std::filesystem::path& path, const BytePicture& picture,
                const std::string& description);

/// Reads the image description of a picture, or what a PDF carries in its place (PdfDescription.h); empty
/// where there is none. Throws Error where it cannot be read.
std::string readImageDescription(const std::filesystem::path& path);

/// How many pixels a picture has each way; nothing of a PDF. Throws Error (input) where it cannot be read.
std::optional<glm::ivec2> readImageSize(const std::filesystem::path& path);

/// The pixels of a picture of 8 bits in three or four channels, as RGB; alpha is left out. Throws Error
/// (input) where it is none, or damaged.
BytePicture readBytes(const std::filesystem::path& path);

/// The floats of an EXR picture that writeImage wrote, or the radiance beside them, with the picture's alpha.
/// Throws Error (input) where it is none, has no radiance, or is damaged.
enum class ExrLayer { picture, radiance };
Image readExr(const std::filesystem::path& path, ExrLayer layer = ExrLayer::picture);

/// Whether a picture is there and can be read to its end.
bool isWholePicture(const std::filesystem::path& path);

} // namespace limn
