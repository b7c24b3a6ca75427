// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/pixels/DicomCodestream.h"

namespace limn {

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
