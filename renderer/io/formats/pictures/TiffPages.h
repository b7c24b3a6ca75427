// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace limn {

/// The number of pages of a TIFF or BigTIFF file, once all that its directories point to has been found
/// inside the file: readers take a chain of pages that breaks off for its end, and missing strips for zeros.
/// Throws Error where the file is cut off or damaged. Source: TIFF 6.0, section 2; BigTIFF design of libtiff.
int tiffPages(const std::filesystem::path& file);

} // namespace limn
