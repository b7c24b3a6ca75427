// SPDX-License-Identifier: GPL-3.0-or-later
#include "FuzzInput.h"

#include "io/formats/pictures/PictureStack.h"

// The chain of a TIFF file's pages, which is checked before the library sees the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = limn::test::fileOf(limn::test::textOf(data, size));
  limn::test::harmless([&] { limn::tiffPages(file); });
  return 0;
}
