// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Image.h"

#include <filesystem>
#include <string>

namespace limn {

/// Writes a picture by its extension: PNG, TIFF and JPEG as 8 bits composited over `background` (0..1), EXR
/// as premultiplied float RGBA without it. `description` (ASCII, may be empty) goes into the image
/// description. Atomic: the file is complete or untouched. Throws Error, also where JPEG cannot hold the size
/// (65,500 pixels a side) or the description (60,000 bytes).
void writeImage(const std::filesystem::path& path, const Image& image, const glm::dvec3& background,
                const std::string& description);

/// Reads the image description of a picture; empty where there is none. Throws Error where it cannot be read.
std::string readImageDescription(const std::filesystem::path& path);

} // namespace limn
