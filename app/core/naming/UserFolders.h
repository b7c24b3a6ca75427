// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace limn {

/// Where the program keeps what it remembers of this user on this machine.
struct UserFolders {
  std::filesystem::path settings; ///< the file of the settings
  std::filesystem::path presets;  ///< own presets
  std::filesystem::path sessions; ///< sessions that nobody saved
  std::filesystem::path reports;  ///< of the stability checks

  static UserFolders ofThisUser();

  /// All of them below one folder.
  static UserFolders below(const std::filesystem::path& folder);
};

/// Makes a folder, and those above it, where they are missing. Throws Error where it cannot be made.
void makeFolder(const std::filesystem::path& folder);

/// Makes a folder that only this user may look into, and those above it, where they are missing. Throws
/// Error where it cannot be made.
void makePrivateFolder(const std::filesystem::path& folder);

} // namespace limn
