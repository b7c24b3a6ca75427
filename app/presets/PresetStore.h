// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/sources/BuiltInPresets.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace limn {

/// The user's own presets: one JSON file each in a folder.
class PresetStore {
public:
  explicit PresetStore(std::filesystem::path folder);

  /// A store in the platform's data folder for this program.
  static PresetStore ofThisUser();

  /// What could be read, by name, and one sentence for each file that could not, or repeats a name.
  struct Contents {
    std::vector<Preset> presets;
    std::vector<Message> problems;
  };
  Contents read() const;

  /// The preset of this name as its file has it now; absent where there is none. Throws Error where it cannot
  /// be read.
  std::optional<Preset> find(const std::string& name) const;

  /// Throws Error (usage) where a name is too long for a file.
  void requireFits(const std::string& name) const;

  /// Writes a preset atomically, replacing the one of the same name. Throws Error.
  void save(const Preset& preset) const;

  /// Removes a preset by name; nothing happens where there is none. Throws Error.
  void remove(const std::string& name) const;

private:
  std::filesystem::path fileOf(const std::string& name) const;
  std::filesystem::path fileHolding(const std::string& name) const;
  std::filesystem::path m_folder;
};

/// The built-in presets, then the user's own that could be read.
std::vector<Preset> allPresets(const PresetStore& store);

/// The preset of this name, upper and lower case alike where no name matches exactly, or of this name behind
/// its modality where one alone is called so: "bone" is "CT bone". Throws Error (usage) that lists the names.
Preset presetNamed(const std::vector<Preset>& presets, const std::string& name);

} // namespace limn
