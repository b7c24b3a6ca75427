// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/describe/Descriptions.h"

#include <sstream>

namespace limn {
namespace {

// A word between single quotes, as fish reads it.
std::string fishQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\')
      quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words)
    line += (line.empty() ? "" : " ") + fishQuoted(word);
  return line;
}

// The condition under which a completion is offered: the words that lead to the command were typed, and none
// that leads further.
std::string conditionOf(const CommandWords& command, const std::string& path) {
  std::string condition;
  std::istringstream words(path);
  for (std::string word; words >> word;)
    condition += (condition.empty() ? "" : "; and ") + ("__fish_seen_subcommand_from " + word);
  if (command.commands.empty())
    return condition;
  std::string further;
  for (const CommandWords& below : command.commands)
    further += " " + below.name;
  return condition + (condition.empty() ? "" : "; and ") + "not __fish_seen_subcommand_from" + further;
}

// What is offered as a value; fish offers files by itself unless -f or -x forbids it.
std::string candidates(const ValueWords& value) {
  const std::vector<std::string> known = value.known();
  std::string offered;
  if (!known.empty() && value.isList)
    offered += "(__limn_list " + joined(known) + ")";
  else
    offered += joined(known);
  for (const std::string& ending : value.endings)
    offered += (offered.empty() ? "" : " ") + ("(__fish_complete_suffix " + ending + ")");
  if (value.isFolder)
    offered += (offered.empty() ? "" : " ") + std::string("(__fish_complete_directories)");
  return offered;
}

std::string lineOf(const OptionWords& option, const std::string& start) {
  std::string line = start;
  for (const std::string& name : option.names)
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  if (!option.valueName.empty()) {
    const std::string offered = candidates(option.value);
    line += option.value.isFile && option.value.endings.empty() ? " -r" : " -x";
    line += offered.empty() ? "" : " -a " + fishQuoted(offered);
  }
  return line + " -d " + fishQuoted(option.what) + "\n";
}

std::string linesOf(const CommandWords& command, const std::string& path) {
  const std::string start = "complete -c limn -n " + fishQuoted(conditionOf(command, path));
  std::string lines;
  for (const CommandWords& below : command.commands)
    lines += start + " -a " + below.name + " -d " + fishQuoted(below.what) + "\n";
  for (const OptionWords& option : command.options)
    lines += lineOf(option, start);
  const ValueWords value = command.places.empty() ? ValueWords() : command.places.front().value;
  const std::string offered = candidates(value);
  if (value.isFile && value.endings.empty())
    lines += start + " -F\n";
  return offered.empty() ? lines : lines + start + " -a " + fishQuoted(offered) + "\n";
}

const char* const fishStart = R"sh(# Completion of limn for fish, made by `limn describe fish`.

# Words that a list separated by commas may go on with.
function __limn_list
  set -l before (string replace -r '[^,]*$' '' -- (commandline -ct))
  printf '%s\n' $before$argv
end

complete -c limn -f
)sh";

} // namespace

std::string fishCompletion(const CommandWords& program) {
  std::string script = fishStart + linesOf(program, {});
  forEachCommand(program, [&](const CommandWords& command, const std::string& path) {
    script += linesOf(command, path);
  });
  return script;
}

} // namespace limn
