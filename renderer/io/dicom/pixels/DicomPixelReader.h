// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/pixels/DicomCodestream.h"

namespace limn {

/// Reads the frames of one file, compressed or not. The header must be supported and outlive the reader.
class DicomPixelReader {
public:
  /// Opens the file and finds its frames. Throws Error (input) where the pixels are cut off.
  explicit DicomPixelReader(const DicomHeader& header);

  /// The pixels of a frame, little-endian, the samples of a pixel together. Throws Error (input).
  DicomRawFrame frame(int index);

private:
  struct Fragment {
    std::uint64_t offset = 0;
    std::uint64_t length = 0;
  };

  void findFragments();
  void assignFragments(const std::vector<Fragment>& fragments, const std::vector<std::uint32_t>& offsets);
  bool startsFrame(const Fragment& fragment);
  std::vector<unsigned char> bytesAt(std::uint64_t offset, std::uint64_t length);
  std::vector<unsigned char> uncompressed(int index);
  [[noreturn]] void fail(const Message& why) const;

  const DicomHeader* m_header;
  std::unique_ptr<std::istream> m_stream;
  std::vector<std::vector<Fragment>> m_frames; // compressed: the fragments of each frame
};

} // namespace limn
