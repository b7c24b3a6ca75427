// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Message.h"

#include <glm/glm.hpp>
#include <nlohmann/json_fwd.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace limn {

/// A closed or half-open range of numbers a field accepts.
struct Limits {
  double lowest = std::numeric_limits<double>::lowest();
  double highest = std::numeric_limits<double>::max();
  bool openBelow = false; ///< true: `lowest` itself is refused
};

/// What most fields accept.
inline constexpr Limits anyNumber{};
inline constexpr Limits notNegative{0.0, std::numeric_limits<double>::max()};
inline constexpr Limits positive{0.0, std::numeric_limits<double>::max(), true};
inline constexpr Limits fraction{0.0, 1.0};

/// The words for the values of an enumeration, in their order.
template <class Enum, std::size_t size>
struct Words {
  std::array<const char*, size> inOrder;

  const char* of(Enum value) const { return inOrder[static_cast<std::size_t>(value)]; }
};

/// Reads one JSON object field by field and refuses what it was not asked for. Every method leaves its target
/// alone where the field is absent and throws Error (input) naming document, field and rule where it is
/// wrong.
class JsonFields {
public:
  /// `where` names the object in errors, e.g. `shading`; empty for the document itself.
  JsonFields(const nlohmann::json& object, std::string document, std::string where);

  bool has(const std::string& key);
  const nlohmann::json& child(const std::string& key);
  JsonFields object(const std::string& key) { return JsonFields(child(key), m_document, pathOf(key)); }

  bool number(const std::string& key, double& target, const Limits& limits = anyNumber);
  bool integer(const std::string& key, int& target, int lowest, int highest);
  bool boolean(const std::string& key, bool& target);
  bool text(const std::string& key, std::string& target);
  bool vector(const std::string& key, glm::dvec3& target, const Limits& limits = anyNumber);
  bool pair(const std::string& key, double& first, double& second, const Limits& limits);

  template <class Enum, std::size_t size>
  bool choice(const std::string& key, Enum& target, const Words<Enum, size>& words) {
    const std::optional<std::size_t> place = choice(key, words.inOrder);
    if (place)
      target = static_cast<Enum>(*place);
    return place.has_value();
  }

  /// The same for values that `nameOf` names.
  template <class Enum, std::size_t size>
  bool choice(const std::string& key, Enum& target, const std::array<Enum, size>& values) {
    std::array<const char*, size> words{};
    std::transform(values.begin(), values.end(), words.begin(), [](Enum value) { return nameOf(value); });
    const std::optional<std::size_t> place = choice(key, words);
    if (place)
      target = values[*place];
    return place.has_value();
  }

  /// Refuses every field that no method asked for, by name.
  void finish() const;

  [[noreturn]] void fail(const std::string& key, const Message& problem) const;
  const std::string& document() const { return m_document; }

  /// The name of a field in errors.
  std::string pathOf(const std::string& key) const { return m_where.empty() ? key : m_where + "." + key; }

private:
  std::optional<std::size_t> choice(const std::string& key, std::span<const char* const> words);
  double numberIn(const nlohmann::json& value, const std::string& key, const Limits& limits) const;

  const nlohmann::json& m_object;
  std::string m_document;
  std::string m_where;
  std::set<std::string> m_known;
};

/// Refuses a document whose `key` is not the version that this program reads; `what` it would be otherwise.
void requireVersion(JsonFields& fields, const std::string& key, const Message& what);

/// The text as JSON. Throws Error (input) calling the file `name`.
nlohmann::json parsedJson(std::string_view text, const std::string& name);

/// JSON as the text of a file, ASCII.
std::string textOf(const nlohmann::ordered_json& json);

} // namespace limn
