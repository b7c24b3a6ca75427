// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/Look.h"

#include <string>

namespace limn {

/// Whether a built-in preset or one of the user's own has that name.
bool namesPreset(const std::string& word);

/// Whether a word of the command line is a file with looks in it rather than the name of a preset: no preset
/// has that name, and there is such a file, or the word has a folder or an ending.
bool namesLookFile(const std::string& word);

/// The look of that name in a file, or where `look` is empty the first one; of several, `changes` says which.
/// Throws Error (input), or (usage) for a name that is not there.
ReadLook lookIn(const std::string& file, const std::optional<LookTarget>& target,
                const std::string& look = {});

/// The preset that --preset asks for on a volume: a built-in one fitted to it, one of the user's own, or the
/// first look of a file. What is to be said of it goes to stderr unless `isQuiet`. Throws Error.
Preset presetAskedFor(const std::string& word, const Volume& volume, bool isQuiet);

/// How a report or label calls it: a preset by its name, a file without its folder.
std::string calledName(const std::string& word);

} // namespace limn
