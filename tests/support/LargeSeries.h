// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/DicomBuilder.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace limn::test {

/// Columns and rows, and slices, of a body of 16 bits: more than a third of the least memory that a process
/// may be told to keep for itself (MemoryBudget).
constexpr int largeSide = 256;
constexpr int largeSlices = 170;
constexpr std::size_t largeBytes = std::size_t{largeSide} * largeSide * largeSlices * sizeof(std::int16_t);

/// A ball in air, in HU, and a pattern upon it.
inline std::vector<std::int16_t> largeSlice(int k) {
  std::vector<std::int16_t> voxels;
  for (int j = 0; j < largeSide; ++j)
    for (int i = 0; i < largeSide; ++i) {
      const int x = i - largeSide / 2, y = j - largeSide / 2, z = k - largeSlices / 2;
      const int ball = 1200 - (x * x + y * y + z * z) / 3;
      voxels.push_back(static_cast<std::int16_t>(std::max(ball, -1000) + (7 * i + 13 * j + 29 * k) % 50));
    }
  return voxels;
}

/// A raw MetaImage.
inline void writeLargeVolume(const std::filesystem::path& file) {
  const std::string side = std::to_string(largeSide);
  std::ofstream out(file, std::ios::binary);
  out << "ObjectType = Image\nNDims = 3\nDimSize = " << side << " " << side << " " << largeSlices
      << "\nElementSpacing = 1 1 1\nElementType = MET_SHORT\nModality = MET_MOD_CT\nComment = ";
  const std::string end = "\nElementDataFile = LOCAL\n";
  while ((static_cast<std::size_t>(out.tellp()) + end.size()) % 8 !=
         0) // numbers are mapped where they may lie
    out << 'x';
  out << end;
  for (int k = 0; k < largeSlices; ++k) {
    const std::vector<std::int16_t> voxels = largeSlice(k);
    out.write(reinterpret_cast<const char*>(voxels.data()),
              static_cast<std::streamsize>(voxels.size() * sizeof(std::int16_t)));
  }
}

/// What is uncommon about a series.
struct LargeSeriesKind {
  double shearMm = 0.0;     ///< by which each slice lies further along y than the one below
  bool hasRescales = false; ///< a slope of its own in every slice
};

/// A CT series of an image a file.
inline void writeLargeSeries(const std::filesystem::path& folder, const LargeSeriesKind& kind = {}) {
  for (int k = 0; k < largeSlices; ++k) {
    DicomBuilder file;
    file.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.2")
        .text(0x00080018, "UI", "1.2.3.4." + std::to_string(k));
    file.text(0x00080060, "CS", "CT").text(0x0020000D, "UI", "1.2.3").text(0x0020000E, "UI", "1.2.3.4");
    file.text(0x00200013, "IS", std::to_string(k));
    file.text(0x00200032, "DS", "0\\" + std::to_string(kind.shearMm * k) + "\\" + std::to_string(k));
    file.text(0x00200037, "DS", "1\\0\\0\\0\\1\\0").text(0x00280030, "DS", "1\\1");
    file.us(0x00280002, {1}).text(0x00280004, "CS", "MONOCHROME2");
    file.us(0x00280010, {largeSide}).us(0x00280011, {largeSide});
    file.us(0x00280100, {16}).us(0x00280101, {16}).us(0x00280102, {15}).us(0x00280103, {1});
    file.text(0x00281052, "DS", "0")
        .text(0x00281053, "DS", kind.hasRescales ? "1." + std::to_string(k) : "1");
    file.pixels(largeSlice(k)).write(folder / (std::to_string(k) + ".dcm"));
  }
}

/// Grey pictures of 16 bits: PNG files in a folder, or where `path` ends with .tif the pages of one file.
/// False where one cannot be written.
inline bool writeLargeStack(const std::filesystem::path& path) {
  const bool isOneFile = path.extension() == ".tif";
  if (!isOneFile)
    std::filesystem::create_directories(path);
  const OIIO::ImageSpec spec(largeSide, largeSide, 1, OIIO::TypeDesc::UINT16);
  std::unique_ptr<OIIO::ImageOutput> out;
  for (int k = 0; k < largeSlices; ++k) {
    const std::string name = (isOneFile ? path : path / ("slice" + std::to_string(k) + ".png")).string();
    const bool isNew = k == 0 || !isOneFile;
    if (isNew)
      out = OIIO::ImageOutput::create(name);
    std::vector<std::uint16_t> pixels;
    for (const std::int16_t value : largeSlice(k))
      pixels.push_back(static_cast<std::uint16_t>(value + 1000));
    if (!out ||
        !out->open(name, spec, isNew ? OIIO::ImageOutput::Create : OIIO::ImageOutput::AppendSubimage) ||
        !out->write_image(OIIO::TypeDesc::UINT16, pixels.data()))
      return false;
  }
  return out->close();
}

} // namespace limn::test
