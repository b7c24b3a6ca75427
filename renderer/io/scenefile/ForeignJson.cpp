// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/ForeignJson.h"

#include "io/reading/ReadError.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace limn {
namespace {

using ParsedJson = nlohmann::json;

bool hasAny(const ParsedJson& object, std::initializer_list<const char*> keys) {
  return std::ranges::any_of(keys, [&](const char* key) { return object.contains(key); });
}

// 3D Slicer names a schema of its own in all that it writes.
bool isOfSlicer(const ParsedJson& object) {
  const auto schema = object.find("@schema");
  if (schema == object.end() || !schema->is_string())
    return false;
  std::string address = schema->get<std::string>();
  std::ranges::transform(address, address.begin(), [](unsigned char c) { return std::tolower(c); });
  return address.find("slicer") != std::string::npos;
}

// ParaView writes a list of colour maps.
bool isOfParaView(const ParsedJson& text) {
  return text.is_array() && !text.empty() && text[0].is_object() &&
         hasAny(text[0], {"ColorSpace", "RGBPoints"});
}

// What it is, as in "it is …"; empty where it may be a scene or session.
Message kindOf(const ParsedJson& text) {
  if (text.is_object() && hasAny(text, {"limn_scene", "limn_session", "volume", "transfer_function"}))
    return {};
  if (isOfParaView(text))
    return Message::tr("a list of ParaView's colour maps");
  if (!text.is_object())
    return Message::tr("JSON of another program");
  if (text.contains("limn_preset"))
    return Message::tr("a preset of Limn, which shows a volume but names none");
  if (text.contains("limn_settings"))
    return Message::tr("Limn's own settings");
  if (isOfSlicer(text) || text.contains("volumeProperties"))
    return text.contains("markups") ? Message::tr("markups of 3D Slicer")
                                    : Message::tr("a file of 3D Slicer (volume rendering properties)");
  return text.empty() ? Message::tr("an empty JSON object")
                      : Message::tr("JSON of another program (its first key is \"%1\")")
                            .arg(text.begin().key().substr(0, 40));
}

} // namespace

void refuseForeignJson(std::string_view text, const std::string& name) {
  const ParsedJson parsed = ParsedJson::parse(text, nullptr, false);
  if (parsed.is_discarded())
    return;
  if (const Message kind = kindOf(parsed); !kind.empty())
    failReading(name, Message::tr("it is %1, not a scene or session that Limn saved").arg(kind),
                Message::tr("open the volume itself and choose a preset"));
}

} // namespace limn
