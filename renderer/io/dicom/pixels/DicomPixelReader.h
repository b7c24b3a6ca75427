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

/// What unpacking found and could not keep.
struct DicomUnpackNotes {
  bool ignoredBits = false; ///< bits outside the stored ones were set (old overlays)
};

/// Turns the raw pixels of a frame into stored values, one per pixel: the stored bits with their sign, the
/// luminance of colour and palettes. Whole words that equal the declared padding are kept as they are.
/// `out` has columns × rows places; T holds every value of the header's bits and sign.
template <class T>
void unpackFrame(const DicomHeader& header, const DicomRawFrame& raw, T* out, DicomUnpackNotes& notes);

extern template void unpackFrame(const DicomHeader&, const DicomRawFrame&, std::uint8_t*, DicomUnpackNotes&);
extern template void unpackFrame(const DicomHeader&, const DicomRawFrame&, std::int8_t*, DicomUnpackNotes&);
extern template void unpackFrame(const DicomHeader&, const DicomRawFrame&, std::uint16_t*, DicomUnpackNotes&);
extern template void unpackFrame(const DicomHeader&, const DicomRawFrame&, std::int16_t*, DicomUnpackNotes&);
extern template void unpackFrame(const DicomHeader&, const DicomRawFrame&, std::uint32_t*, DicomUnpackNotes&);
extern template void unpackFrame(const DicomHeader&, const DicomRawFrame&, std::int32_t*, DicomUnpackNotes&);
extern template void unpackFrame(const DicomHeader&, const DicomRawFrame&, double*, DicomUnpackNotes&);

} // namespace limn
