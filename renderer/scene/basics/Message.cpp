// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/basics/Message.h"

#include <array>
#include <charconv>

namespace limn {
namespace {

// In the C locale, whatever the window system sets.
std::string fixed(double number, int decimals) {
  std::array<char, 400> digits; // 1e308 has 309
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::fixed, decimals);
  return {digits.data(), end.ptr};
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

Message Message::arg(double number, int decimals) const {
  Message digits(fixed(number, decimals));
  digits.m_kind = Kind::number;
  digits.m_number = number;
  digits.m_decimals = decimals;
  return arg(digits);
}

Message Message::followedBy(const char* separator, const Message& next) const {
  if (empty() || next.empty())
    return empty() ? next : *this;
  Message both("%1" + std::string(separator) + "%2"); // which no list of words needs to hold
  both.m_kind = Kind::pattern;
  return both.arg(*this).arg(next);
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
