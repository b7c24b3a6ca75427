// SPDX-License-Identifier: GPL-3.0-or-later
#include "VolumeFuzz.h"

#include "io/formats/metaimage/MetaImageFile.h"

// MetaImage: header, raw, text and zlib voxels, names of detached raw files.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  limn::test::readWhole(limn::test::textOf(data, size), limn::readMetaImage);
  return 0;
}
