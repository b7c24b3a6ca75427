// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/json/JsonText.h"

#include "scene/basics/Error.h"

#include <nlohmann/json.hpp>

namespace limn {

nlohmann::json parsedJson(std::string_view text, const std::string& name) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    throw Error(Error::Kind::input, name + " is not valid JSON (the mistake is near byte " +
                                        std::to_string(error.byte) +
                                        "); open it in a text editor to repair it.");
  } catch (const nlohmann::json::out_of_range&) {
    throw Error(Error::Kind::input,
                name + " holds a number too large to be one; open it in a text editor to repair it.");
  }
}

std::string textOf(const nlohmann::ordered_json& json) {
  // File names may hold bytes that are not UTF-8; they are replaced rather than lost with the whole file.
  return json.dump(2, ' ', true, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace limn
