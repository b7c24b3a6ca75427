// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace limn {

/// A word between single quotes, as bash and zsh read it.
inline std::string shellQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'')
      quoted += "'\\'";
    quoted += c;
  }
  return quoted + "'";
}

/// Words, each quoted, with spaces between.
inline std::string shellQuoted(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words)
    line += (line.empty() ? "" : " ") + shellQuoted(word);
  return line;
}

} // namespace limn
