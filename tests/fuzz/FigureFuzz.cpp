// SPDX-License-Identifier: GPL-3.0-or-later
#include "FuzzInput.h"

#include "io/scenefile/FigureFile.h"

// A figure that was read is written so that it reads again as the same; telling one from a scene never fails.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace limn;
  const std::string_view text = test::textOf(data, size);
  looksLikeFigure(text);
  test::harmless([&] {
    const std::string written = figureToJson(parseFigure(text, "input"));
    if (figureToJson(parseFigure(written, "written")) != written)
      test::fault("a figure is written and does not read again as the same");
  });
  return 0;
}
