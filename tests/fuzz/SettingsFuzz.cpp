// SPDX-License-Identifier: GPL-3.0-or-later
#include "FuzzInput.h"

#include "io/scenefile/SettingsFile.h"

// Settings that were read are written so that they read again as the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace limn;
  test::harmless([&] {
    const std::string written = settingsToJson(parseSettings(test::textOf(data, size), "input"));
    if (settingsToJson(parseSettings(written, "written")) != written)
      test::fault("settings are written and do not read again as the same");
  });
  return 0;
}
