// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/describe/CommandWords.h"

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

/// A manual page (man(7), section 1) of the program with all its commands. `date` is YYYY-MM-DD.
std::string manPage(const CommandWords& program, const std::string& version, const std::string& date);

// Completions for shells: commands, options, words and files where values stand. Scripts of one file each.
std::string bashCompletion(const CommandWords& program); ///< bash 4.0 and later; needs no other package
std::string zshCompletion(const CommandWords& program);  ///< to be called _limn in a folder of $fpath
std::string fishCompletion(const CommandWords& program); ///< fish 3.0 and later

/// Calls `visit` with every command below the program and the words that lead to it, such as "presets list".
template <class Visit>
void forEachCommand(const CommandWords& program, const Visit& visit, const std::string& path = {}) {
  for (const CommandWords& command : program.commands) {
    const std::string words = path.empty() ? command.name : path + " " + command.name;
    visit(command, words);
    forEachCommand(command, visit, words);
  }
}

} // namespace limn
