// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/VolumeBytes.h"
#include "io/dicom/DicomFolder.h"
#include "scene/basics/Error.h"
#include "support/DicomBuilder.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace limn::test {

/// What openDicom finds, read; of what is no DICOM the error of a file that should be.
inline std::shared_ptr<const Volume> readDicom(const std::filesystem::path& path, const ReadOptions& options,
                                               const Progress& progress) {
  if (const auto dicom = openDicom(path, progress))
    return dicom->read(options, progress);
  parseDicom(path);
  return nullptr;
}

/// Columns and rows of a synthetic slice.
constexpr int sliceColumns = 3;
constexpr int sliceRows = 2;

/// The stored value of pixel (i, j) of the slice with that image number.
inline int storedAt(int number, int i, int j) {
  return 100 * number + 10 * j + i;
}

/// An axial CT slice of 3 × 2 pixels, 0.5 mm between columns and 0.75 mm between rows, at height `z`, with
/// values storedAt(number, i, j) and HU = stored - 1024.
inline DicomBuilder slice(int number, double z) {
  DicomBuilder file;
  file.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.2");
  file.text(0x00080018, "UI", "1.2.3.4." + std::to_string(number));
  file.text(0x00080060, "CS", "CT").text(0x0020000D, "UI", "1.2.3").text(0x0020000E, "UI", "1.2.3.4");
  file.text(0x00200013, "IS", std::to_string(number));
  file.text(0x00200032, "DS", "-10\\-20\\" + std::to_string(z));
  file.text(0x00200037, "DS", "1\\0\\0\\0\\1\\0").text(0x00280030, "DS", "0.75\\0.5");
  file.us(0x00280002, {1}).text(0x00280004, "CS", "MONOCHROME2");
  file.us(0x00280010, {sliceRows}).us(0x00280011, {sliceColumns});
  file.us(0x00280100, {16}).us(0x00280101, {16}).us(0x00280102, {15}).us(0x00280103, {1});
  file.text(0x00281052, "DS", "-1024").text(0x00281053, "DS", "1").text(0x00281054, "LO", "HU");
  std::vector<std::int16_t> pixels;
  for (int j = 0; j < sliceRows; ++j)
    for (int i = 0; i < sliceColumns; ++i)
      pixels.push_back(static_cast<std::int16_t>(storedAt(number, i, j)));
  return file.pixels(pixels);
}

/// One whose first row lies a row further back than that of the slice 2 mm below, as of a tilted gantry.
inline DicomBuilder slantingSlice(int number) {
  return slice(number, 2.0 * number)
      .text(0x00200032, "DS",
            "-10\\" + std::to_string(-20.0 + 0.75 * (number - 1)) + "\\" + std::to_string(2 * number));
}

/// The reason for which a path is refused; empty where it is read.
inline std::string dicomRefusal(const std::filesystem::path& path) {
  try {
    readDicom(path, {}, {});
    return {};
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), Error::Kind::input);
    return error.what();
  }
}

/// The reason for which a file named "image" is refused; empty where it is read.
inline std::string dicomRefusal(const DicomBuilder& file) {
  TemporaryFolder folder;
  file.write(folder.path() / "image");
  return dicomRefusal(folder.path() / "image");
}

} // namespace limn::test
