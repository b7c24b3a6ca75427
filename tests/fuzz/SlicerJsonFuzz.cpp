// SPDX-License-Identifier: GPL-3.0-or-later
#include "LookFuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  limn::test::fuzzLook(limn::slicerJsonFormat(), limn::test::textOf(data, size));
  return 0;
}
