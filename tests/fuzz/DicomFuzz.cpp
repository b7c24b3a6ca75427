// SPDX-License-Identifier: GPL-3.0-or-later
#include "FuzzInput.h"

#include "io/dicom/DicomVoxels.h"
#include "io/dicom/header/DicomHeader.h"
#include "io/dicom/header/DicomTags.h"
#include "io/dicom/pixels/DicomPixelReader.h"

// The header of a DICOM file, deflated or not, the facts of its frames, and the pixels of those that no
// library decodes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace limn;
  const auto file = test::fileOf(test::textOf(data, size));
  test::harmless([&] {
    const DicomHeader header = headerOf(file, parseDicom(file));
    requireSupported(header);
    requireWhole(header);
    DicomPixelReader pixels(header);
    const bool isOurs = !header.pixels->isEncapsulated || header.transferSyntax == "1.2.840.10008.1.2.5";
    if (isOurs && pixels.frame(0).bytes.size() != frameBytes(header))
      test::fault("a frame does not fill the picture");
  });
  return 0;
}
