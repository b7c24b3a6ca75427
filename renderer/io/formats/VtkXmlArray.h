// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/Bytes.h"

#include <string>
#include <string_view>

namespace limn {

/// How the arrays of a VTK XML file are written.
struct VtkXmlEncoding {
  bool bigEndian = false;
  int bytesPerLength = 4; ///< of the lengths before the data: 4 (UInt32) or 8 (UInt64)
  bool isCompressed = false;
};

/// Delivers the next bytes that were encoded as one unit; throws Error where they are not all there.
using UnitReader = std::function<std::string(std::uint64_t bytes)>;

/// Units of base64 text, which must outlive the reader. White space is allowed between the letters.
UnitReader base64Units(const std::filesystem::path& file, std::string_view text);

/// Units of plain bytes at an offset of the file.
UnitReader plainUnits(const std::filesystem::path& file, std::uint64_t offset);

/// The bytes of an array: its lengths are read and compared with `expected`, its blocks inflated one by one.
/// Throws Error where they do not agree, on the spot or while the bytes are read.
/// Source: VTK File Formats, "XML File Formats"; header of vtkXMLDataReader.
ByteReader arrayBytes(const std::filesystem::path& file, const UnitReader& units,
                      const VtkXmlEncoding& encoding, std::uint64_t expected);

} // namespace limn
