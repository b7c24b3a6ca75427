// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/dicom/NewUid.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>

namespace limn {

std::string newUid() {
  std::random_device chance;
  std::array<std::uint32_t, 4> words{};
  for (std::uint32_t& word : words)
    word = chance();
  words[1] = (words[1] & 0xFFFF0FFFu) | 0x00004000u; // version 4: random
  words[2] = (words[2] & 0x3FFFFFFFu) | 0x80000000u; // variant of RFC 4122
  // 128 bits to decimal digits by long division, the last digit first.
  std::string digits;
  while (std::any_of(words.begin(), words.end(), [](std::uint32_t word) { return word != 0; })) {
    std::uint64_t rest = 0;
    for (std::uint32_t& word : words) {
      const std::uint64_t part = rest << 32 | word;
      word = static_cast<std::uint32_t>(part / 10);
      rest = part % 10;
    }
    digits += static_cast<char>('0' + rest);
  }
  return "2.25." + std::string(digits.rbegin(), digits.rend());
}

} // namespace limn
