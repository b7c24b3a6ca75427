// SPDX-License-Identifier: GPL-3.0-or-later
#include "VolumeFuzz.h"

#include "io/formats/invesalius/InVesaliusProject.h"

// The archive of an InVesalius project and its entries.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  limn::test::readWhole(limn::test::textOf(data, size), limn::readInVesalius);
  return 0;
}
