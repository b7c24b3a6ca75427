// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/SettingsFile.h"

#include "io/json/JsonFields.h"

#include <nlohmann/json.hpp>

namespace limn {

SettingsDocument parseSettings(std::string_view text, const std::string& name) {
  const nlohmann::json json = parsedJson(text, name);
  JsonFields fields(json, name, "");
  requireVersion(fields, "limn_settings", Message::tr("settings file"));
  SettingsDocument settings;
  if (!fields.has("values") || !fields.child("values").is_object())
    fields.fail("values", Message::tr("must be a list of keys with texts"));
  JsonFields values = fields.object("values");
  for (const auto& [key, value] : fields.child("values").items())
    values.text(key, settings[key]);
  fields.finish();
  return settings;
}

std::string settingsToJson(const SettingsDocument& settings) {
  return textOf({{"limn_settings", 1}, {"values", settings}});
}

} // namespace limn
