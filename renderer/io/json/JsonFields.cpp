// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/json/JsonFields.h"

#include "io/reading/ReadError.h"
#include "scene/basics/Error.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <sstream>

namespace limn {
namespace {

std::string written(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

Message described(const Limits& limits) {
  const bool below = limits.lowest > std::numeric_limits<double>::lowest();
  const bool above = limits.highest < std::numeric_limits<double>::max();
  if (below && above)
    return (limits.openBelow ? Message::tr("above %1 to %2") : Message::tr("from %1 to %2"))
        .arg(written(limits.lowest), written(limits.highest));
  if (below)
    return (limits.openBelow ? Message::tr("above %1") : Message::tr("at least %1"))
        .arg(written(limits.lowest));
  return above ? Message::tr("at most %1").arg(written(limits.highest)) : Message::tr("any number");
}

// Whoever reads this wrote no JSON, as a rule.
const Message saveAgain = Message::tr("save the file again in the program that made it");
const Message saveAgainOrCorrect =
    Message::tr("save the file again in the program that made it, or correct that in a text editor");

} // namespace

JsonFields::JsonFields(const nlohmann::json& object, std::string document, std::string where)
    : m_object(object), m_document(std::move(document)), m_where(std::move(where)) {
  if (!m_object.is_object())
    failReading(m_document,
                m_where.empty()
                    ? Message::tr("it does not hold what such a file holds")
                    : Message::tr("its \"%1\" does not hold what it should: names and their values in braces")
                          .arg(m_where),
                saveAgain);
}

void JsonFields::fail(const std::string& key, const Message& problem) const {
  failReading(m_document, Message::tr("its \"%1\" %2").arg(pathOf(key), problem), saveAgainOrCorrect);
}

bool JsonFields::has(const std::string& key) {
  m_known.insert(key);
  return m_object.contains(key);
}

const nlohmann::json& JsonFields::child(const std::string& key) {
  m_known.insert(key);
  return m_object.at(key);
}

double JsonFields::numberIn(const nlohmann::json& value, const std::string& key, const Limits& limits) const {
  if (!value.is_number())
    fail(key, Message::tr("must be a number"));
  const double number = value.get<double>();
  const bool tooLow = limits.openBelow ? !(number > limits.lowest) : !(number >= limits.lowest);
  if (tooLow || !(number <= limits.highest) || !std::isfinite(number))
    fail(key, Message::tr("is %1 and must be %2").arg(written(number), described(limits)));
  return number;
}

bool JsonFields::number(const std::string& key, double& target, const Limits& limits) {
  if (!has(key))
    return false;
  target = numberIn(m_object.at(key), key, limits);
  return true;
}

bool JsonFields::integer(const std::string& key, int& target, int lowest, int highest) {
  if (!has(key))
    return false;
  if (!m_object.at(key).is_number_integer())
    fail(key, Message::tr("must be a whole number"));
  target = static_cast<int>(
      numberIn(m_object.at(key), key, {static_cast<double>(lowest), static_cast<double>(highest)}));
  return true;
}

bool JsonFields::boolean(const std::string& key, bool& target) {
  if (!has(key))
    return false;
  if (!m_object.at(key).is_boolean())
    fail(key, Message::tr("must be true or false"));
  target = m_object.at(key).get<bool>();
  return true;
}

bool JsonFields::text(const std::string& key, std::string& target) {
  if (!has(key))
    return false;
  if (!m_object.at(key).is_string())
    fail(key, Message::tr("must be a text in quotes"));
  target = m_object.at(key).get<std::string>();
  return true;
}

bool JsonFields::vector(const std::string& key, glm::dvec3& target, const Limits& limits) {
  if (!has(key))
    return false;
  const nlohmann::json& value = m_object.at(key);
  if (!value.is_array() || value.size() != 3)
    fail(key, Message::tr("must be a list of three numbers"));
  for (int axis = 0; axis < 3; ++axis)
    target[axis] = numberIn(value[static_cast<std::size_t>(axis)], key, limits);
  return true;
}

bool JsonFields::pair(const std::string& key, double& first, double& second, const Limits& limits) {
  if (!has(key))
    return false;
  const nlohmann::json& value = m_object.at(key);
  if (!value.is_array() || value.size() != 2)
    fail(key, Message::tr("must be a list of two numbers"));
  first = numberIn(value[0], key, limits);
  second = numberIn(value[1], key, limits);
  return true;
}

std::optional<std::size_t> JsonFields::choice(const std::string& key, std::span<const char* const> words) {
  std::string word, known;
  if (!text(key, word))
    return std::nullopt;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (word == words[i])
      return i;
    known += (known.empty() ? "" : ", ") + std::string(words[i]);
  }
  fail(key, Message::tr("is \"%1\" and must be one of %2").arg(word, known));
}

void JsonFields::finish() const {
  for (const auto& [key, value] : m_object.items())
    if (!m_known.contains(key))
      fail(key, Message::tr("is nothing that Limn knows there"));
}

void requireVersion(JsonFields& fields, const std::string& key, const Message& what) {
  int version = 0;
  if (!fields.integer(key, version, 1, 1000000))
    failReading(fields.document(), Message::tr("it is no %1 of Limn").arg(what),
                Message::tr("choose another file"));
  if (version != 1)
    failReading(fields.document(), Message::tr("it is a %1 of a newer Limn").arg(what),
                Message::tr("open it with that one"));
}

nlohmann::json parsedJson(std::string_view text, const std::string& name) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    failReading(name, Message::tr("it is damaged or cut off (near its character %1)").arg(error.byte),
                saveAgainOrCorrect);
  } catch (const nlohmann::json::out_of_range&) {
    failReading(name, Message::tr("it holds a number that is too large to be one"), saveAgainOrCorrect);
  }
}

std::string textOf(const nlohmann::ordered_json& json) {
  // File names may hold bytes that are not UTF-8; they are replaced rather than lost with the whole file.
  return json.dump(2, ' ', true, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace limn
