// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Bytes.h"

#include <string>

namespace limn {

/// How a VTK XML file writes its arrays in binary form.
struct VtkXmlEncoding {
  bool bigEndian = false;
  int bytesPerLength = 4; ///< of the lengths before the values
  bool isCompressed = false;
  bool isBase64 = false;
};

/// The values of an array of `expected` bytes out of its coded bytes, decoded as they are asked for. Throws
/// Error, naming `file`, also later as it reads, where the lengths before the values do not fit or the bytes
/// are damaged.
ByteReader arrayBytes(const std::filesystem::path& file, const ByteReader& coded,
                      const VtkXmlEncoding& encoding, std::uint64_t expected);

} // namespace limn
