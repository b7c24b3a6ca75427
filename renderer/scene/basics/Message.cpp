// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/Message.h"

#include <array>
#include <charconv>

namespace limn {
namespace {

// In the C locale, whatever the window system sets.
std::string inDigits(double number, std::chars_format format, int digits) {
  std::array<char, 400> text; // 1e308 has 309
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number, format, digits);
  return {text.data(), end.ptr};
}

} // namespace

Message Message::tr(const char* pattern) {
  Message message(pattern);
  message.m_kind = Kind::pattern;
  return message;
}

Message Message::arg(const Message& message) const {
  Message filled = *this;
  filled.m_arguments.push_back(message);
  return filled;
}

Message Message::fixed(double number, int decimals) {
  Message message(inDigits(number, std::chars_format::fixed, decimals));
  message.m_kind = Kind::fixed;
  message.m_number = number;
  message.m_digits = decimals;
  return message;
}

Message Message::rounded(double number, int digits) {
  Message message(inDigits(number, std::chars_format::general, digits));
  message.m_kind = Kind::rounded;
  message.m_number = number;
  message.m_digits = digits;
  return message;
}

Message Message::followedBy(const char* separator, const Message& next) const {
  if (empty() || next.empty())
    return empty() ? next : *this;
  Message both("%1" + std::string(separator) + "%2"); // which no list of words needs to hold
  both.m_kind = Kind::pattern;
  return both.arg(*this).arg(next);
}

Message Message::withVerbatim(const std::function<std::string(const std::string&)>& changed) const {
  Message result = *this;
  if (m_kind == Kind::verbatim)
    result.m_text = changed(m_text);
  for (Message& argument : result.m_arguments)
    argument = argument.withVerbatim(changed);
  return result;
}

std::string Message::english() const {
  if (m_kind != Kind::pattern)
    return m_text;
  std::string filled;
  for (std::size_t i = 0; i < m_text.size(); ++i) {
    const bool isPlace =
        m_text[i] == '%' && i + 1 < m_text.size() && m_text[i + 1] >= '1' && m_text[i + 1] <= '9';
    const std::size_t place = isPlace ? static_cast<std::size_t>(m_text[i + 1] - '1') : 0;
    if (!isPlace || place >= m_arguments.size()) {
      filled += m_text[i];
      continue;
    }
    filled += m_arguments[place].english();
    ++i;
  }
  return filled;
}

} // namespace limn
