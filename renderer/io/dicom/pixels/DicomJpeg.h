// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace limn {

/// A decoded JPEG picture: samples little-endian as wide as their depth asks (1 or 2 bytes), the samples of a
/// pixel together, colours as coded.
struct JpegPicture {
  std::vector<unsigned char> bytes;
  bool isMarkedYbr = false; ///< JFIF or Adobe marks say that the components are Y, Cb and Cr
};

/// A JPEG stream that does not decode whole; the text says why, in the words of the library.
class JpegDamage : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// Decode a classic JPEG stream (lossy, or lossless) of samples up to 8, 12 or 16 bits. GDCM carries one
/// build of the JPEG library for each depth; they are called here directly, because its own wrapper prints
/// damage and carries on. Throw JpegDamage.
JpegPicture decodeJpeg8(const std::vector<unsigned char>& stream);
JpegPicture decodeJpeg12(const std::vector<unsigned char>& stream);
JpegPicture decodeJpeg16(const std::vector<unsigned char>& stream);

} // namespace limn
