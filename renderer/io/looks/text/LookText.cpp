// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/text/LookText.h"

#include "io/json/JsonFields.h"

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>

namespace limn {

void tell(std::vector<Message>& changes, const Message& sentence) {
  if (std::find(changes.begin(), changes.end(), sentence) == changes.end())
    changes.push_back(sentence);
}

std::string changesJson(const std::vector<Message>& changes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Message& change : changes)
    list.push_back({{"what", change.english()}});
  return textOf({{"changes", list}});
}

std::optional<double> leadingNumber(std::string_view text, std::size_t* used) {
  const std::size_t sign = text.starts_with('+') ? 1 : 0;
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data() + sign, end, number);
  if (problem != std::errc{})
    return std::nullopt;
  if (used)
    *used = static_cast<std::size_t>(stop - text.data());
  return number;
}

std::string shortest(double number) {
  std::array<char, 32> text{};
  const auto [end, problem] = std::to_chars(text.data(), text.data() + text.size(), number);
  return std::string(text.data(), static_cast<std::size_t>(end - text.data()));
}

std::string xmlText(const pugi::xml_document& document) {
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

} // namespace limn
