// SPDX-License-Identifier: GPL-3.0-or-later
#include "FuzzInput.h"

#include "io/scenefile/SceneFile.h"

// A preset that was read is written so that it reads again as the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace limn;
  test::harmless([&] {
    const std::string written = presetToJson(parsePreset(test::textOf(data, size), "input"));
    if (presetToJson(parsePreset(written, "written")) != written)
      test::fault("a preset is written and does not read again as the same");
  });
  return 0;
}
