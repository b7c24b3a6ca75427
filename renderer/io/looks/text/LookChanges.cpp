// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/text/LookChanges.h"

#include "io/json/JsonFields.h"

#include <nlohmann/json.hpp>

#include <algorithm>

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

} // namespace limn
