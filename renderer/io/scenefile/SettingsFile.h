// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace limn {

/// What a program remembers between runs: texts by key.
using SettingsDocument = std::map<std::string, std::string>;

/// Reads the text of a settings file. `name` is how errors call it. Throws Error (input).
SettingsDocument parseSettings(std::string_view text, const std::string& name);

/// Settings as JSON.
std::string settingsToJson(const SettingsDocument& settings);

} // namespace limn
