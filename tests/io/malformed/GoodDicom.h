// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/DicomBuilder.h"

namespace limn::test {

/// The good volume as one DICOM file of four frames, placed as a dose grid is: values = stored.
inline DicomBuilder goodMultiframe() {
  DicomBuilder file;
  file.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.481.2").text(0x00080018, "UI", "1.2.3.4.9");
  file.text(0x00080060, "CS", "MR").text(0x0020000D, "UI", "1.2.3").text(0x0020000E, "UI", "1.2.3.9");
  file.text(0x00200032, "DS", "-10\\-20\\5").text(0x00200037, "DS", "1\\0\\0\\0\\1\\0");
  file.text(0x00280030, "DS", "3\\2").text(0x3004000C, "DS", "0\\4\\8\\12");
  file.us(0x00280002, {1}).text(0x00280004, "CS", "MONOCHROME2").text(0x00280008, "IS", "4");
  file.us(0x00280010, {3}).us(0x00280011, {2});
  file.us(0x00280100, {16}).us(0x00280101, {16}).us(0x00280102, {15}).us(0x00280103, {1});
  std::vector<std::int16_t> pixels;
  for (std::int16_t i = 0; i < 24; ++i)
    pixels.push_back(i);
  return file.pixels(pixels);
}

/// An object that holds no picture by its kind: a structured report.
inline DicomBuilder goodReport() {
  DicomBuilder file;
  file.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.88.11").text(0x00080018, "UI", "1.2.3.5.1");
  file.text(0x00080060, "CS", "SR").text(0x0020000D, "UI", "1.2.3").text(0x0020000E, "UI", "1.2.3.5");
  return file;
}

/// Slice `number` of the good volume as a file of its own.
inline DicomBuilder goodSlice(int number) {
  DicomBuilder file;
  file.text(0x00080016, "UI", "1.2.840.10008.5.1.4.1.1.4");
  file.text(0x00080018, "UI", "1.2.3.4." + std::to_string(number + 1));
  file.text(0x00080060, "CS", "MR").text(0x0020000D, "UI", "1.2.3").text(0x0020000E, "UI", "1.2.3.4");
  file.text(0x00200013, "IS", std::to_string(number + 1));
  file.text(0x00200032, "DS", "-10\\-20\\" + std::to_string(4 * number));
  file.text(0x00200037, "DS", "1\\0\\0\\0\\1\\0").text(0x00280030, "DS", "3\\2");
  file.us(0x00280002, {1}).text(0x00280004, "CS", "MONOCHROME2");
  file.us(0x00280010, {3}).us(0x00280011, {2});
  file.us(0x00280100, {16}).us(0x00280101, {16}).us(0x00280102, {15}).us(0x00280103, {1});
  std::vector<std::int16_t> pixels;
  for (int i = 0; i < 6; ++i)
    pixels.push_back(static_cast<std::int16_t>(6 * number + i));
  return file.pixels(pixels);
}

} // namespace limn::test
