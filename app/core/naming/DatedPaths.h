// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/scenefile/SettingsFile.h"

#include <string>
#include <vector>

namespace limn {

/// Paths that settings keep under PREFIX name /path, some with /label and with the moment /opened.
inline const std::string pathSuffix = "/path";
inline const std::string labelSuffix = "/label";
inline const std::string openedSuffix = "/opened";

/// What an entry is kept under: PREFIX name and one of the above.
std::string entryKey(const std::string& prefix, const std::string& name, const std::string& suffix);

/// The name under which this path is kept; empty where it is not.
std::string nameOf(const SettingsDocument& values, const std::string& prefix, const std::string& path);

/// A name that no other entry has, and that tells nothing.
std::string newName();

/// An entry and when it was opened last.
struct DatedEntry {
  std::string name;
  std::string opened; ///< ISO date with milliseconds, UTC
};

/// Those under PREFIX with a moment, latest first.
std::vector<DatedEntry> datedEntries(const SettingsDocument& values, const std::string& prefix);

/// Takes an entry out with all that it says.
void forget(SettingsDocument& values, const std::string& prefix, const std::string& name);

/// Puts a path first under PREFIX, `fresh` being its name where it has none, and returns the name; beyond
/// `most` the last ones go.
std::string putFirst(SettingsDocument& values, const std::string& prefix, const std::string& path,
                     const std::string& fresh, std::size_t most);

} // namespace limn
