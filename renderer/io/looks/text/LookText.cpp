// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/text/LookText.h"

#include <array>
#include <charconv>

namespace limn {

std::optional<double> leadingNumber(std::string_view text, std::size_t* used) {
  const std::size_t sign = text.starts_with('+') ? 1 : 0;
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data() + sign, end, number);
  if (problem != std::errc{})
    return std::nullopt;
  if (used)
    *used = static_cast<std::size_t>(stop - text.data());
  return number;
}

std::string shortest(double number) {
  std::array<char, 32> text{};
  const auto [end, problem] = std::to_chars(text.data(), text.data() + text.size(), number);
  return std::string(text.data(), static_cast<std::size_t>(end - text.data()));
}

} // namespace limn
