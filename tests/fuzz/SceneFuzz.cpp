// SPDX-License-Identifier: GPL-3.0-or-later
#include "FuzzInput.h"

#include "io/scenefile/SceneFile.h"

// A scene that was read is written so that it reads again as the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace limn;
  test::harmless([&] {
    const SceneDocument first = parseScene(test::textOf(data, size), "input");
    const std::string written = sceneToJson(first.scene, first.volume);
    if (sceneToJson(parseScene(written, "written").scene, first.volume) != written)
      test::fault("a scene is written and does not read again as the same");
  });
  return 0;
}
