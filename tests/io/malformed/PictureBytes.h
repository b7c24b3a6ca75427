// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "GoodBytes.h"

#include <map>

namespace limn::test {

/// One page of a TIFF file: entries of its directory by tag, and the bytes of its picture.
struct TiffPage {
  struct Entry {
    std::uint16_t type = 3; ///< 3: 16 bits, 4: 32 bits
    std::uint32_t count = 1;
    std::uint32_t value = 0;
  };
  std::map<std::uint16_t, Entry> entries;
  std::string picture;
};

/// Page `number` of the good volume: 2 × 3 pixels of 16 bits in one strip, deflated or not.
TiffPage goodPage(int number, bool isDeflated = false);

/// A TIFF file of pages. The last points to the directory of the page `next`, or ends the chain where that is
/// -1.
std::string tiffOf(const std::vector<TiffPage>& pages, int next = -1);

/// The good volume as one TIFF file.
std::string goodTiff(bool isDeflated = false);

/// A PNG file of grey (colour type 0) or other pixels: `rows` are the scan lines with their filter bytes.
std::string pngOf(std::uint32_t width, std::uint32_t height, int bits, int colourType,
                  const std::string& deflatedRows, const std::string& moreChunks = "");

/// A chunk of a PNG file with its check sum.
std::string pngChunk(const std::string& type, const std::string& bytes);

/// Slice `number` of the good volume as an 8-bit PNG file.
std::string goodPng(int number);

} // namespace limn::test
