// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/families/Families.h"
#include "io/scenefile/SceneFile.h"

namespace limn {
namespace {

bool isLimnPreset(std::string_view text) {
  return text.find("\"limn_preset\"") != std::string_view::npos;
}

std::vector<ReadLook> readLimnPreset(std::string_view text, const std::string& name,
                                     const std::optional<LookTarget>&) {
  return {{parsePreset(text, name), {}}};
}

WrittenLook writeLimnPreset(const Preset& preset, const std::optional<LookTarget>&) {
  return {presetToJson(preset), {}};
}

} // namespace

LookFormat limnPresetFormat() {
  return {Message::tr("Limn preset"), {".json"}, isLimnPreset, readLimnPreset, writeLimnPreset};
}

} // namespace limn
