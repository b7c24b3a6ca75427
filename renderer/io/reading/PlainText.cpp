// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/reading/PlainText.h"

namespace limn {

std::string plainText(std::string text, std::size_t most) {
  for (char& c : text)
    c = (c >= 0 && c < ' ') || c == 0x7f ? '?' : c;
  if (text.size() <= most)
    return text;
  // Not within a letter of several bytes.
  while (most > 0 && (static_cast<unsigned char>(text[most]) & 0xC0) == 0x80)
    --most;
  return text.substr(0, most) + "…";
}

} // namespace limn
