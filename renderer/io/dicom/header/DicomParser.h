// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/header/DicomDataset.h"

#include <filesystem>
#include <istream>
#include <memory>
#include <string>

namespace limn {

/// Where the pixels of a file are: byte offset and length in the stream that openDicomStream gives.
struct DicomPixelLocation {
  std::uint64_t offset = 0;
  std::uint64_t length = 0;       ///< meaningless where encapsulated
  bool isEncapsulated = false;    ///< a sequence of compressed fragments
  bool isFloatingPoint = false;   ///< Float or Double Float Pixel Data
  bool isWordSwapped = false;     ///< big-endian words: bytes of 8-bit pixels come in swapped pairs
  std::uint64_t streamLength = 0; ///< bytes in the whole stream
};

/// A parsed file: its attributes up to the pixels, and where those are.
struct DicomFile {
  DicomDataset dataset; ///< group 0002 included
  std::string transferSyntax;
  std::optional<DicomPixelLocation> pixels; ///< absent where the file holds no image
  std::uint64_t deflatedFrom = 0; ///< byte of the file where the deflated part starts; 0 where none does
};

/// Parses the attributes of a file with or without preamble and group 0002, in any transfer syntax; opens it
/// once. Nothing where it does not start as DICOM does (the preamble, or at least three sound elements of
/// group 0002 or 0008) or cannot be read. Trusts no length. Throws Error (input) where its header is damaged
/// or cut off.
std::optional<DicomFile> parseIfDicom(const std::filesystem::path& path);

/// The same; throws Error (input) where the file is no DICOM, too.
DicomFile parseDicom(const std::filesystem::path& path);

/// Opens the stream to which a DicomPixelLocation refers: the file, or what its deflated part inflates to.
/// Throws Error (input).
std::unique_ptr<std::istream> openDicomStream(const std::filesystem::path& path, std::uint64_t deflatedFrom);

} // namespace limn
