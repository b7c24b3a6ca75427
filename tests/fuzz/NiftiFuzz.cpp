// SPDX-License-Identifier: GPL-3.0-or-later
#include "VolumeFuzz.h"

#include "io/formats/nifti/NiftiFile.h"

// NIfTI in one file, compressed or not, and Analyze headers.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  limn::test::readWhole(limn::test::textOf(data, size), limn::readNifti);
  return 0;
}
