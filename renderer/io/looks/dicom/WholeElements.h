// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace limn::dicom {

/// Where the attributes of a file begin, and how they are encoded.
struct Encoding {
  std::size_t start = 0; ///< behind preamble and meta information
  bool isExplicit = true;
};

/// Walks over a file before DCMTK does, which makes room for whatever length an element announces: every
/// element lies within the item or file that holds it, there are at most 400,000 of them, in at most 32
/// levels. Little endian, uncompressed. Throws Error (input).
Encoding requireWholeElements(std::string_view bytes, const std::string& name);

} // namespace limn::dicom
