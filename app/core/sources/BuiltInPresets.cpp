// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/sources/BuiltInPresets.h"

#include "io/scenefile/SceneFile.h"

#include <string>
#include <utility>

namespace limn {

/// Names and texts of the files in `presets`, in the order of CMakeLists.txt; EmbedPresets.cmake writes it.
std::vector<std::pair<std::string, std::string>> embeddedPresets();

std::vector<Preset> builtInPresets() {
  static const std::vector<Preset> known = [] {
    std::vector<Preset> presets;
    for (const auto& [name, text] : embeddedPresets())
      presets.push_back(parsePreset(text, name));
    return presets;
  }();
  return known;
}

} // namespace limn
