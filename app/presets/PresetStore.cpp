// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/presets/PresetStore.h"

#include "app/core/naming/MeantWord.h"
#include "app/core/naming/UserFolders.h"
#include "io/AtomicFile.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"

#include <QString>

#include <algorithm>
#include <cctype>
#include <set>

namespace limn {
namespace {

constexpr std::size_t longestFileName = 255; // of the usual file systems, bytes

// In alphabetical order, so that of two presets of one name it is always the same that counts.
std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code missing;
  for (const auto& entry : std::filesystem::directory_iterator(folder, missing))
    if (entry.path().extension() == ".json" && !isTemporary(entry.path()))
      files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

Preset presetIn(const std::filesystem::path& file) {
  return parsePreset(readTextFile(file), file.filename().string());
}

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
  std::set<std::string> taken;
  for (const Preset& preset : builtInPresets())
    taken.insert(preset.name);
  for (const std::filesystem::path& file : filesIn(m_folder))
    try {
      Preset preset = presetIn(file);
      if (!taken.insert(preset.name).second)
        throw Error(
            Error::Kind::input,
            Message::tr("The preset file %1 is left out: another preset is called \"%2\"; give it a name "
                        "of its own.")
                .arg(file.filename().string())
                .arg(preset.name));
      contents.presets.push_back(std::move(preset));
    } catch (const Error& error) {
      contents.problems.push_back(error.sentence());
    }
  std::ranges::sort(contents.presets, [](const Preset& a, const Preset& b) { return a.name < b.name; });
  return contents;
}

// Usually the one that is named after it; somebody may have named another by hand. Empty: none.
std::filesystem::path PresetStore::fileHolding(const std::string& name) const {
  if (std::error_code unknown; std::filesystem::exists(fileOf(name), unknown))
    return fileOf(name);
  for (const std::filesystem::path& file : filesIn(m_folder))
    try {
      if (presetIn(file).name == name)
        return file;
    } catch (const Error&) {
      // Whatever it is, it is not this one.
    }
  return {};
}

std::optional<Preset> PresetStore::find(const std::string& name) const {
  const std::filesystem::path file = fileHolding(name);
  return file.empty() ? std::nullopt : std::optional(presetIn(file));
}

void PresetStore::requireFits(const std::string& name) const {
  if (fileOf(name).filename().string().size() > longestFileName)
    throw Error(
        Error::Kind::usage,
        Message::tr("Cannot save the preset: its name is too long for a file; choose a shorter one."));
}

void PresetStore::save(const Preset& preset) const {
  requireFits(preset.name);
  const std::filesystem::path file = fileOf(preset.name);
  makeFolder(m_folder);
  const std::filesystem::path before = fileHolding(preset.name);
  writeFileAtomically(file, presetToJson(preset), FilePlace::fixed);
  std::error_code failed; // then the list says that two have one name
  if (!before.empty() && before != file)
    std::filesystem::remove(before, failed);
}

void PresetStore::remove(const std::string& name) const {
  const std::filesystem::path file = fileHolding(name);
  std::error_code failed;
  if (!file.empty())
    std::filesystem::remove(file, failed);
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

// "Bone" as the window's list calls "CT bone" below "CT"; none where several are called so.
static const Preset* underHeading(const std::vector<Preset>& presets, const QString& name) {
  const Preset* found = nullptr;
  for (const Preset& preset : presets) {
    const QString whole = QString::fromStdString(preset.modality) + QLatin1Char(' ') + name;
    if (QString::fromStdString(preset.name).compare(whole, Qt::CaseInsensitive) != 0)
      continue;
    if (found)
      return nullptr;
    found = &preset;
  }
  return found;
}

Preset presetNamed(const std::vector<Preset>& presets, const std::string& name) {
  const QString wanted = QString::fromStdString(name);
  for (const Qt::CaseSensitivity sensitivity : {Qt::CaseSensitive, Qt::CaseInsensitive})
    for (const Preset& preset : presets)
      if (QString::fromStdString(preset.name).compare(wanted, sensitivity) == 0)
        return preset;
  if (const Preset* meant = underHeading(presets, wanted))
    return *meant;
  std::vector<std::string> names;
  std::string known;
  for (const Preset& preset : presets) {
    known += (known.empty() ? "" : ", ") + preset.name;
    names.push_back(preset.name);
  }
  const std::string meant = meantBy(name, names);
  throw Error(Error::Kind::usage,
              meant.empty() ? Message::tr("There is no preset \"%1\"; there are: %2.").arg(name).arg(known)
                            : Message::tr("There is no preset \"%1\"; did you mean \"%2\"? The command limn "
                                          "presets list names all.")
                                  .arg(name)
                                  .arg(meant));
}

} // namespace limn
