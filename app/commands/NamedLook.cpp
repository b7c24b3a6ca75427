// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/NamedLook.h"

#include "app/commands/Arguments.h"
#include "app/presets/PresetStore.h"
#include "scene/basics/Error.h"
#include "scene/presets/PresetFit.h"
#include "scene/volume/Volume.h"

#include <algorithm>

namespace limn {
namespace {

std::string namesOf(const std::vector<ReadLook>& looks) {
  constexpr std::size_t most = 20;
  std::string names;
  for (std::size_t i = 0; i < std::min(most, looks.size()); ++i)
    names += (i > 0 ? ", " : "") + looks[i].preset.name;
  return looks.size() > most ? names + ", …" : names;
}

} // namespace

bool namesPreset(const std::string& word) {
  try {
    presetNamed(allPresets(PresetStore::ofThisUser()), word);
    return true;
  } catch (const Error&) {
    return false;
  }
}

bool namesLookFile(const std::string& word) {
  if (namesPreset(word))
    return false;
  std::error_code failed;
  return std::filesystem::is_regular_file(word, failed) || word.find('/') != std::string::npos ||
         std::filesystem::path(word).has_extension();
}

ReadLook lookIn(const std::string& file, const std::optional<LookTarget>& target, const std::string& look) {
  std::vector<ReadLook> looks = readLooks(file, target);
  const auto found =
      look.empty() ? looks.begin() : std::find_if(looks.begin(), looks.end(), [&](const ReadLook& read) {
        return read.preset.name == look;
      });
  if (found == looks.end())
    throw Error(Error::Kind::usage, Message::tr("%1 has no look \"%2\"; it has: %3.")
                                        .arg(std::filesystem::path(file).filename().string())
                                        .arg(look)
                                        .arg(namesOf(looks)));
  if (look.empty() && looks.size() > 1)
    found->changes.insert(found->changes.begin(), Message::tr("Of its %1 looks the first, \"%2\", was taken.")
                                                      .arg(looks.size())
                                                      .arg(found->preset.name));
  return std::move(*found);
}

Preset presetAskedFor(const std::string& word, const Volume& volume, bool isQuiet) {
  if (namesLookFile(word)) {
    const ReadLook read = lookIn(word, lookTargetOf(volume));
    if (!isQuiet)
      for (const Message& change : read.changes)
        note(change.english());
    return read.preset;
  }
  // Own presets were shaped on data like this; built-in ones fit themselves to it.
  Preset preset = presetNamed(allPresets(PresetStore::ofThisUser()), word);
  const std::vector<Preset> builtIn = builtInPresets();
  if (std::find(builtIn.begin(), builtIn.end(), preset) == builtIn.end())
    return preset;
  if (isForHounsfield(preset) && !looksLikeHounsfield(volume) && !isQuiet)
    note("\"" + preset.name +
         "\" is made for Hounsfield units, which this volume does not have: it may show nothing, "
         "or the wrong tissue.");
  return fittedTo(preset, histogramOf(volume), volume.grid());
}

std::string calledName(const std::string& word) {
  if (namesLookFile(word))
    return lookNameOf(word);
  return namesPreset(word) ? presetNamed(allPresets(PresetStore::ofThisUser()), word).name : word;
}

} // namespace limn
