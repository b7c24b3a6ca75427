// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/presets/PresetStore.h"

#include "app/UserFolders.h"
#include "io/AtomicFile.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"

#include <QString>

#include <algorithm>
#include <cctype>

namespace limn {
namespace {

constexpr std::size_t longestFileName = 255; // of the usual file systems, bytes

} // namespace

PresetStore::PresetStore(std::filesystem::path folder) : m_folder(std::move(folder)) {}

PresetStore PresetStore::ofThisUser() {
  return PresetStore(UserFolders::ofThisUser().presets);
}

std::filesystem::path PresetStore::fileOf(const std::string& name) const {
  // Every byte that is not plain becomes its code, so that two names never share a file.
  std::string plain;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    static constexpr char digits[] = "0123456789abcdef";
    if (byte < 128 && (std::isalnum(byte) || c == '-' || c == ' '))
      plain += c;
    else
      plain += {'%', digits[byte >> 4], digits[byte & 15]};
  }
  return m_folder / (plain + ".json");
}

PresetStore::Contents PresetStore::read() const {
  Contents contents;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(m_folder, missing)) {
    if (entry.path().extension() != ".json" || isTemporary(entry.path()))
      continue;
    try {
      contents.presets.push_back(parsePreset(readTextFile(entry.path()), entry.path().filename().string()));
    } catch (const Error& error) {
      contents.problems.push_back(error.sentence());
    }
  }
  std::ranges::sort(contents.presets, [](const Preset& a, const Preset& b) { return a.name < b.name; });
  return contents;
}

void PresetStore::save(const Preset& preset) const {
  if (fileOf(preset.name).filename().string().size() > longestFileName)
    throw Error(
        Error::Kind::usage,
        Message::tr("Cannot save the preset: its name is too long for a file; choose a shorter one."));
  makeFolder(m_folder);
  writeFileAtomically(fileOf(preset.name), presetToJson(preset), FilePlace::fixed);
}

void PresetStore::remove(const std::string& name) const {
  std::error_code failed;
  std::filesystem::remove(fileOf(name), failed);
  if (failed)
    throw Error(Error::Kind::other,
                Message::tr("Cannot delete the preset \"%1\": %2.").arg(name).arg(failed.message()));
}

std::vector<Preset> allPresets(const PresetStore& store) {
  std::vector<Preset> presets = builtInPresets();
  for (Preset& own : store.read().presets)
    presets.push_back(std::move(own));
  return presets;
}

Preset presetNamed(const std::vector<Preset>& presets, const std::string& name) {
  const QString wanted = QString::fromStdString(name);
  for (const Qt::CaseSensitivity sensitivity : {Qt::CaseSensitive, Qt::CaseInsensitive})
    for (const Preset& preset : presets)
      if (QString::fromStdString(preset.name).compare(wanted, sensitivity) == 0)
        return preset;
  std::string known;
  for (const Preset& preset : presets)
    known += (known.empty() ? "" : ", ") + preset.name;
  throw Error(Error::Kind::usage,
              Message::tr("There is no preset \"%1\"; there are: %2.").arg(name).arg(known));
}

} // namespace limn
