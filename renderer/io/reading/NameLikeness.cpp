// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reading/NameLikeness.h"

#include "io/reading/HeaderText.h"

namespace limn {
namespace {

// Empty where it holds a number, as in scan.001 or in a UID.
std::string endingOf(const std::filesystem::path& file) {
  const std::string ending = lowerCase(file.extension().string());
  return ending.find_first_of("0123456789") == std::string::npos ? ending : std::string();
}

// The name with # for each run of digits and points, or for all of a hexadecimal number.
std::string patternOf(const std::filesystem::path& file) {
  const std::string name = lowerCase(file.filename().string());
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

} // namespace

void NameLikeness::add(const std::filesystem::path& slice) {
  m_patterns.insert(patternOf(slice));
  m_endings.insert(endingOf(slice));
}

bool NameLikeness::isLike(const std::filesystem::path& file) const {
  const std::string name = file.filename().string();
  if (name.empty() || name.front() == '.')
    return false;
  const std::string ending = endingOf(file);
  return (!ending.empty() && m_endings.contains(ending)) || m_patterns.contains(patternOf(file));
}

} // namespace limn
