// SPDX-License-Identifier: GPL-3.0-or-later
#include "PictureBytes.h"

namespace limn::test {
namespace {

constexpr std::uint16_t stripOffsets = 273, stripLengths = 279, compression = 259;
constexpr std::uint16_t deflateScheme = 8;

} // namespace

TiffPage goodPage(int number, bool isDeflated) {
  std::vector<std::uint16_t> pixels;
  for (int i = 0; i < 6; ++i)
    pixels.push_back(static_cast<std::uint16_t>(6 * number + i));
  TiffPage page;
  page.picture = isDeflated ? deflated(bytesOf(pixels), false) : bytesOf(pixels);
  page.entries = {{256, {3, 1, 2}},
                  {257, {3, 1, 3}},
                  {258, {3, 1, 16}},
                  {compression, {3, 1, isDeflated ? deflateScheme : 1u}},
                  {262, {3, 1, 1}},
                  {stripOffsets, {4, 1, 0}},
                  {277, {3, 1, 1}},
                  {278, {3, 1, 3}},
                  {stripLengths, {4, 1, static_cast<std::uint32_t>(page.picture.size())}}};
  return page;
}

std::string tiffOf(const std::vector<TiffPage>& pages, int next) {
  std::string bytes = "II" + littleEndian(42, 2) + littleEndian(0, 4);
  std::vector<std::size_t> directories;
  std::size_t link = 4; // where the offset of the next directory is written
  for (const TiffPage& page : pages) {
    const std::size_t picture = bytes.size();
    bytes += page.picture + std::string(page.picture.size() % 2, '\0');
    directories.push_back(bytes.size());
    bytes.replace(link, 4, littleEndian(bytes.size(), 4));
    bytes += littleEndian(page.entries.size(), 2);
    for (const auto& [tag, entry] : page.entries) {
      const bool isPlace = tag == stripOffsets && entry.value == 0;
      bytes += littleEndian(tag, 2) + littleEndian(entry.type, 2) + littleEndian(entry.count, 4) +
               littleEndian(isPlace ? picture : entry.value, 4);
    }
    link = bytes.size();
    bytes += littleEndian(0, 4);
  }
  if (next >= 0)
    bytes.replace(link, 4, littleEndian(directories[static_cast<std::size_t>(next)], 4));
  return bytes;
}

std::string goodTiff(bool isDeflated) {
  std::vector<TiffPage> pages;
  for (int number = 0; number < 4; ++number)
    pages.push_back(goodPage(number, isDeflated));
  return tiffOf(pages);
}

std::string pngChunk(const std::string& type, const std::string& bytes) {
  const std::string body = type + bytes;
  const auto sum = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return bigEndian(bytes.size(), 4) + body + bigEndian(sum, 4);
}

std::string pngOf(std::uint32_t width, std::uint32_t height, int bits, int colourType,
                  const std::string& deflatedRows, const std::string& moreChunks) {
  const std::string header = bigEndian(width, 4) + bigEndian(height, 4) + static_cast<char>(bits) +
                             static_cast<char>(colourType) + std::string(3, '\0');
  return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header) + moreChunks + pngChunk("IDAT", deflatedRows) +
         pngChunk("IEND", "");
}

std::string goodPng(int number) {
  std::string rows;
  for (int j = 0; j < 3; ++j) {
    rows += '\0';
    for (int i = 0; i < 2; ++i)
      rows += static_cast<char>(6 * number + 2 * j + i);
  }
  return pngOf(2, 3, 8, 0, deflated(rows, false));
}

} // namespace limn::test
