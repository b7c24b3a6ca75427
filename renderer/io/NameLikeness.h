// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

namespace limn {

/// The names of the slices of a folder, to tell a lost slice by its name from a foreign file.
class NameLikeness {
public:
  /// Adds the name of a slice.
  void add(const std::filesystem::path& slice) {
    m_patterns.insert(patternOf(slice));
    m_endings.insert(endingOf(slice));
  }

  /// Whether a file is called as a slice is: the same letters around other numbers, or the same ending (one
  /// of letters). Hidden files never are, because systems leave such beside the files they copy.
  bool isLike(const std::filesystem::path& file) const {
    const std::string name = file.filename().string();
    if (name.empty() || name.front() == '.')
      return false;
    const std::string ending = endingOf(file);
    return (!ending.empty() && m_endings.contains(ending)) || m_patterns.contains(patternOf(file));
  }

private:
  static std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
  }

  // Empty where it holds a number, as in scan.001 or in a UID.
  static std::string endingOf(const std::filesystem::path& file) {
    const std::string ending = lower(file.extension().string());
    return ending.find_first_of("0123456789") == std::string::npos ? ending : std::string();
  }

  // The name with # for each run of digits and points, or for all of a hexadecimal number.
  static std::string patternOf(const std::filesystem::path& file) {
    const std::string name = lower(file.filename().string());
    if (name.find_first_not_of("0123456789abcdef.-") == std::string::npos &&
        name.find_first_of("0123456789") != std::string::npos)
      return "#";
    std::string pattern;
    for (const char c : name)
      if (c != '.' && !(c >= '0' && c <= '9'))
        pattern += c;
      else if (pattern.empty() || pattern.back() != '#')
        pattern += '#';
    return pattern;
  }

  std::set<std::string> m_patterns;
  std::set<std::string> m_endings;
};

} // namespace limn
