// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pugixml.hpp>

#include <optional>
#include <string>
#include <vector>

namespace limn {

/// A dictionary of an Apple property list in XML, asked by key, whatever the order. Keys that are absent give
/// what is passed for that; `file` is how errors call it. Throws Error (input) where a value is of a wrong
/// kind.
class PlistFields {
public:
  PlistFields(const pugi::xml_node& dict, const std::string& file) : m_dict(dict), m_file(file) {}

  pugi::xml_node value(const char* key) const;
  std::string text(const char* key) const;
  double number(const char* key, double absent) const;
  bool flag(const char* key, bool absent) const;
  /// The items of a list; none where it is absent.
  std::vector<pugi::xml_node> list(const char* key) const;
  /// A list of numbers.
  std::vector<double> numbers(const char* key) const;

private:
  double numberOf(const pugi::xml_node& value, const char* key) const;

  pugi::xml_node m_dict;
  const std::string& m_file;
};

} // namespace limn
