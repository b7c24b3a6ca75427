// SPDX-License-Identifier: GPL-3.0-or-later
#include "VolumeFuzz.h"

#include "io/formats/vtk/VtkLegacyFile.h"

// Legacy VTK files.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  limn::test::readWhole(limn::test::textOf(data, size), limn::readVtkLegacy);
  return 0;
}
