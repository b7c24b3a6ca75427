// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/families/PlistFields.h"

#include "io/looks/curves/LookCurves.h"
#include "io/reading/HeaderText.h"
#include "io/reading/ReadError.h"

#include <cmath>
#include <string_view>

namespace limn {

pugi::xml_node PlistFields::value(const char* key) const {
  for (const pugi::xml_node& child : m_dict.children("key"))
    if (trimmed(child.text().get()) == key)
      for (pugi::xml_node next = child.next_sibling(); next; next = next.next_sibling())
        if (next.type() == pugi::node_element)
          return next;
  return {};
}

std::string PlistFields::text(const char* key) const {
  return value(key).text().get();
}

double PlistFields::number(const char* key, double absent) const {
  const pugi::xml_node found = value(key);
  return found ? numberOf(found, key) : absent;
}

double PlistFields::numberOf(const pugi::xml_node& found, const char* key) const {
  const std::optional<double> number = numberIn(trimmed(found.text().get()));
  const std::string_view kind = found.name();
  if (!number || !std::isfinite(*number) || (kind != "real" && kind != "integer" && kind != "string"))
    failReading(m_file, Message::tr("its \"%1\" is no finite number").arg(key), saveLookAgain);
  return *number;
}

bool PlistFields::flag(const char* key, bool absent) const {
  const pugi::xml_node found = value(key);
  const std::string_view kind = found.name();
  if (!found)
    return absent;
  if (kind == "true" || kind == "false")
    return kind == "true";
  return numberOf(found, key) != 0.0;
}

std::vector<pugi::xml_node> PlistFields::list(const char* key) const {
  const pugi::xml_node found = value(key);
  if (found && std::string_view(found.name()) != "array")
    failReading(m_file, Message::tr("its \"%1\" is no list").arg(key), saveLookAgain);
  std::vector<pugi::xml_node> items;
  for (const pugi::xml_node& item : found.children())
    if (item.type() == pugi::node_element)
      items.push_back(item);
  return items;
}

std::vector<double> PlistFields::numbers(const char* key) const {
  std::vector<double> result;
  for (const pugi::xml_node& item : list(key))
    result.push_back(numberOf(item, key));
  return result;
}

} // namespace limn
