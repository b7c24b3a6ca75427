// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/describe/Slips.h"

#include "app/core/naming/MeantWord.h"

#include <algorithm>
#include <filesystem>

namespace limn {
namespace {

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

std::string choiceAmong(const std::vector<std::string>& known, const std::string& word) {
  std::string all;
  for (const std::string& one : known)
    all += (all.empty() ? "" : ", ") + one;
  const std::string meant = meantBy(word, known);
  return meant.empty() ? "choose one of " + all : "did you mean " + meant + "? It is one of " + all;
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
