// SPDX-License-Identifier: GPL-3.0-or-later
#include "FuzzInput.h"

#include "io/scenefile/SessionFile.h"

// A session that was read is written so that it reads again as the same; telling one from a scene never
// fails.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace limn;
  const std::string_view text = test::textOf(data, size);
  looksLikeSession(text);
  test::harmless([&] {
    const std::string written = sessionToJson(parseSession(text, "input"));
    if (sessionToJson(parseSession(written, "written")) != written)
      test::fault("a session is written and does not read again as the same");
  });
  return 0;
}
