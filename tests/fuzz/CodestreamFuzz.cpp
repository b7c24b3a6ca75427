// SPDX-License-Identifier: GPL-3.0-or-later
#include "FuzzInput.h"

#include "io/dicom/pixels/DicomCodestream.h"

// What a JPEG, JPEG-LS or JPEG 2000 stream says of its picture; and the same bytes as run lengths of a small
// picture, which the first of them chooses.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace limn;
  if (size == 0)
    return 0;
  const DicomCodestream stream(data + 1, data + size);
  if (const auto facts = factsOf(stream); facts && (facts->columns < 0 || facts->rows < 0))
    test::fault("a picture of negative size");
  DicomHeader header;
  header.columns = 1 + data[0] % 4;
  header.rows = 1 + data[0] / 4 % 4;
  header.format.bitsAllocated = data[0] & 64 ? 16 : 8;
  header.format.samples = data[0] & 128 ? 3 : 1;
  test::harmless([&] {
    if (decodedRunLengths(header, stream).size() != frameBytes(header))
      test::fault("a frame does not fill the picture");
  });
  return 0;
}
