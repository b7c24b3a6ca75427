// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace limn {

struct PictureToWrite;

/// Writes a picture of bytes as PNG in sRGB by libpng, without the two hundred libraries that other formats
/// bring: to load those takes longer than most pictures. The same picture is the same bytes each time. Empty
/// where the file was written, otherwise why not. Throws std::bad_alloc.
std::string writePng(const std::string& path, const PictureToWrite& picture);

} // namespace limn
