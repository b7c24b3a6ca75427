// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace limn {

/// The text as JSON. Throws Error (input) calling the file `name`.
nlohmann::json parsedJson(std::string_view text, const std::string& name);

/// JSON as the text of a file, ASCII.
std::string textOf(const nlohmann::ordered_json& json);

} // namespace limn
