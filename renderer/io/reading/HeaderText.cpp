// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reading/HeaderText.h"

#include "io/reading/ReadError.h"

#include <algorithm>
#include <charconv>

namespace limn {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

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

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string lowerCase(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return result;
}

std::vector<std::string> words(std::string_view text) {
  std::vector<std::string> result;
  while (!(text = trimmed(text)).empty()) {
    const std::size_t end = std::min(text.find_first_of(blanks), text.size());
    result.emplace_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return result;
}

std::vector<double> numbers(const std::filesystem::path& file, std::string_view text) {
  std::vector<double> result;
  for (const std::string& word : words(text))
    result.push_back(number(file, word));
  return result;
}

std::optional<double> numberIn(std::string_view text) {
  if (text.starts_with('+'))
    text.remove_prefix(1);
  double value = 0.0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool isNumber = problem == std::errc{} && end == text.data() + text.size();
  return isNumber ? std::optional(value) : std::nullopt;
}

double number(const std::filesystem::path& file, std::string_view text) {
  const auto value = numberIn(trimmed(text));
  if (!value)
    failReading(file,
                Message::tr("its header has \"%1\" where a number is needed")
                    .arg(std::string(trimmed(text).substr(0, 40))),
                copyAgain);
  return *value;
}

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
