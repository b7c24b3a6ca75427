// SPDX-License-Identifier: GPL-3.0-or-later
#include "VolumeFuzz.h"

#include "io/formats/nrrd/NrrdFile.h"

// NRRD: header, raw, text and gzip voxels, names of detached files.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  limn::test::readWhole(limn::test::textOf(data, size), limn::readNrrd);
  return 0;
}
