// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/header/DicomHeader.h"

namespace limn {

/// The bytes of one compressed frame.
using DicomCodestream = std::vector<unsigned char>;

/// What a JPEG, JPEG-LS or JPEG 2000 stream says of the picture in it.
struct CodestreamFacts {
  int columns = 0;
  int rows = 0;
  int bits = 0;
  int components = 0;
};

/// Reads the frame header of a stream; nothing where there is none.
std::optional<CodestreamFacts> factsOf(const DicomCodestream& stream);

/// A decoded frame: pixels little-endian, the samples of a pixel together.
struct DicomRawFrame {
  std::vector<unsigned char> bytes;
  std::string photometric; ///< after decoding
};

/// Decodes one frame of an encapsulated file, whose header is supported. Checks the stream against the header
/// before any library sees it. Throws Error (input).
DicomRawFrame decoded(const DicomHeader& header, const DicomCodestream& stream);

/// Decodes a run-length encoded frame (PS3.5, annex G) into little-endian pixels.
/// Throws Error (input) where it does not fill the frame.
std::vector<unsigned char> decodedRunLengths(const DicomHeader& header, const DicomCodestream& stream);

} // namespace limn
