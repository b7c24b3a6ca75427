// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/describe/Slips.h"

#include <algorithm>
#include <filesystem>

namespace limn {
namespace {

// The optimal string alignment distance: how many letters are left out, added, changed or swapped.
std::size_t lettersApart(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> apart(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        apart[i][j] = i + j;
        continue;
      }
      const std::size_t changed = a[i - 1] == b[j - 1] ? 0 : 1;
      apart[i][j] = std::min({apart[i - 1][j] + 1, apart[i][j - 1] + 1, apart[i - 1][j - 1] + changed});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        apart[i][j] = std::min(apart[i][j], apart[i - 2][j - 2] + 1);
    }
  return apart[a.size()][b.size()];
}

std::vector<std::string> optionsOf(const CommandWords& command) {
  std::vector<std::string> names;
  for (const OptionWords& option : command.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

const CommandWords* commandNamed(const CommandWords& command, const std::string& word) {
  const auto found = std::ranges::find(command.commands, word, &CommandWords::name);
  return found == command.commands.end() ? nullptr : &*found;
}

std::vector<std::string> commandsOf(const CommandWords& command) {
  std::vector<std::string> names;
  for (const CommandWords& below : command.commands)
    names.push_back(below.name);
  return names;
}

// A word that takes the place of a volume may be anything; it is a slip where no file has this name and a
// command nearly.
bool isUnknownCommand(const CommandWords& command, const std::string& word) {
  if (command.commands.empty())
    return false;
  std::error_code unknown;
  return command.places.empty() ||
         (!meantBy(word, commandsOf(command)).empty() && !std::filesystem::exists(word, unknown));
}

std::string sentence(const std::string& what, const std::string& word, const std::string& command,
                     const std::string& meant) {
  return command + " has no " + what + " " + word + (meant.empty() ? ";" : "; did you mean " + meant + "?") +
         " " + command + " --help lists what there is.";
}

} // namespace

std::string meantBy(const std::string& word, const std::vector<std::string>& known) {
  std::string nearest;
  std::size_t least = word.size() / 3 + 1;
  for (const std::string& candidate : known)
    if (const std::size_t apart = lettersApart(word, candidate); apart < least) {
      least = apart;
      nearest = candidate;
    }
  return nearest;
}

std::string slipIn(const CommandWords& program, const std::vector<std::string>& arguments) {
  const CommandWords* command = &program;
  std::string name = program.name;
  bool mayBeCommand = true;
  for (const std::string& word : arguments) {
    if (word == "--")
      return {};
    if (word.starts_with("--")) {
      const std::string option = word.substr(0, word.find('='));
      const std::vector<std::string> known = optionsOf(*command);
      if (std::ranges::find(known, option) == known.end())
        return sentence("option", option, name, meantBy(option, known));
    } else if (mayBeCommand && !word.starts_with("-")) {
      if (const CommandWords* below = commandNamed(*command, word)) {
        command = below;
        name += " " + word;
        continue;
      }
      if (isUnknownCommand(*command, word))
        return sentence("command", word, name, meantBy(word, commandsOf(*command)));
      mayBeCommand = false;
    }
  }
  return {};
}

} // namespace limn
