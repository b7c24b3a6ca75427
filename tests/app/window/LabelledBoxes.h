// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/WindowHarness.h"
#include "app/picture/RegionController.h"
#include "support/ShortVolume.h"

namespace limn::test {

/// The program's window on a volume of two boxes of one value, side by side, and what labels them:
/// `two.nrrd`, written and not yet open.
class LabelledBoxes : public WindowHarness {
protected:
  static constexpr int boxesSize = 32;

  void SetUp() override {
    WindowHarness::SetUp();
    write("two.nrrd", [](const glm::ivec3& v) { return isInBoxes(v) ? 300 : -1000; });
  }

  static bool isInBoxes(const glm::ivec3& v) {
    return glm::all(glm::greaterThan(v, glm::ivec3(5))) && glm::all(glm::lessThan(v, glm::ivec3(26)));
  }

  template <class Value>
  void write(const char* name, const Value& value) {
    writeShorts(folder.path() / name, boxesSize, value);
  }

  RegionController& regions() { return *window->findChild<RegionController*>(); }
  [[nodiscard]] bool ready() {
    return waitUntil([this] { return !regions().isBusy(); });
  }
  [[nodiscard]] bool openLabels(const char* name) {
    regions().openLabels(pathTo(name));
    return ready() && scene().keep.kind == Region::Kind::labels;
  }
};

} // namespace limn::test
