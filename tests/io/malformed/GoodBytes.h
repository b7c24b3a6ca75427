// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/VolumeBytes.h"

namespace limn::test {

/// The voxels 0 … 23 of the good volume as int16.
inline std::string goodVoxels(bool bigEndian = false) {
  return bytesOf(rising<std::int16_t>(24), bigEndian);
}

/// The same as text.
inline std::string goodText() {
  std::string text;
  for (int i = 0; i < 24; ++i)
    text += std::to_string(i) + (i % 2 ? "\n" : " ");
  return text;
}

/// Deflated data of `start` and then `mebibytes` of zeros, which take a thousandth of that: a bomb. Window
/// bits as zlib's: 31 gzip, 15 zlib, -15 raw. Its check sum is wrong, which only its end would tell.
std::string bomb(const std::string& start, std::size_t mebibytes, int windowBits);

/// The bytes of a little-endian number.
std::string littleEndian(std::uint64_t value, int bytes);

/// The bytes of a big-endian number.
std::string bigEndian(std::uint64_t value, int bytes);

/// `text` with the first `from` in it replaced; throws where there is none.
std::string replaced(std::string text, const std::string& from, const std::string& to);

} // namespace limn::test
