// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/FileLock.h"

#include <filesystem>
#include <string>
#include <vector>

namespace limn {

/// A folder that holds the autosaved session of one window, locked for as long as this object lives.
class AutosavePlace {
public:
  AutosavePlace(std::filesystem::path folder, FileLock lock)
      : m_folder(std::move(folder)), m_lock(std::move(lock)) {}

  std::filesystem::path file() const { return m_folder / "session.json"; }

  /// Removes folder and session. The place is then of no further use.
  void remove() const;

private:
  std::filesystem::path m_folder;
  FileLock m_lock;
};

/// Sessions that nobody saved: those of open windows, those that were left behind by windows whose process
/// ended without closing them, and the last ten that were closed or replaced with unsaved changes. Safe
/// among processes.
class UnsavedSessions {
public:
  explicit UnsavedSessions(std::filesystem::path folder);

  /// A new place. Throws Error where the folder cannot be written.
  AutosavePlace place() const;

  /// The places of dead windows that hold a session, latest first; each goes to one caller only for as long
  /// as that one lives. What else dead windows left is removed. Throws Error.
  std::vector<AutosavePlace> takeAbandoned() const;

  /// Keeps a session that is closed or replaced. Throws Error.
  void keep(const std::string& session) const;

  /// Files of the kept ones, latest first.
  std::vector<std::filesystem::path> kept() const;

private:
  FileLock lockWhole() const;

  std::filesystem::path m_folder;
};

} // namespace limn
