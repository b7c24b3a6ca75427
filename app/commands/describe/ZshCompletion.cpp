// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/describe/Descriptions.h"

#include <algorithm>
#include <sstream>

namespace limn {
namespace {

// "presets list" → "_limn_presets_list"; the program itself: "_limn".
std::string functionOf(const std::string& path, const std::string& option = {}) {
  std::string name = "_limn" + (path.empty() ? "" : "_" + path) + (option.empty() ? "" : "_value" + option);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ' ' || c == '-'; }, '_');
  return name;
}

// A text inside of a specification of _arguments, where brackets and colons mean something.
std::string specText(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\')
      escaped += '\\';
    escaped += c;
  }
  return escaped;
}

// What offers the values of an option; nothing where none are known.
std::string valueFunction(const std::string& name, const ValueWords& value) {
  const std::vector<std::string> known = value.known();
  std::string body;
  if (!known.empty())
    body += (value.isList ? "  _sequence compadd - " : "  compadd -- ") + shellQuoted(known) + "\n";
  if (value.isFolder)
    body += "  _files -/\n";
  if (value.isFile && value.endings.empty())
    body += "  _files\n";
  if (value.isFile && !value.endings.empty()) {
    std::string endings;
    for (const std::string& ending : value.endings)
      endings += (endings.empty() ? "" : "|") + ending.substr(1);
    body += "  _files -g " + shellQuoted("*.(" + endings + ")(-.)") + "\n";
  }
  return body.empty() ? "" : name + "() {\n" + body + "}\n\n";
}

// One option for _arguments, such as '(-o --output)'{-o,--output}'[picture to
// write]:FILE:_limn_render_value__o'.
std::string specOf(const OptionWords& option, const std::string& path, std::ostringstream& functions) {
  std::string names, excluded;
  for (const std::string& name : option.names) {
    names += (names.empty() ? "" : ",") + name;
    excluded += (excluded.empty() ? "" : " ") + name;
  }
  std::string rest = "[" + specText(option.what) + "]";
  if (!option.valueName.empty()) {
    const std::string name = functionOf(path, option.names.back());
    const std::string function = valueFunction(name, option.value);
    functions << function;
    rest += ":" + specText(option.valueName) + ":" + (function.empty() ? " " : name);
  }
  return option.names.size() == 1 ? shellQuoted(names + rest)
                                  : shellQuoted("(" + excluded + ")") + "{" + names + "}" + shellQuoted(rest);
}

std::string commandList(const CommandWords& command) {
  std::string list;
  for (const CommandWords& below : command.commands)
    list += "    " + shellQuoted(specText(below.name) + ":" + below.what) + "\n";
  return list;
}

// The function that completes a command: its options, then what stands in its places.
std::string commandFunction(const CommandWords& command, const std::string& path) {
  std::ostringstream functions, body;
  const std::string name = functionOf(path);
  body << name << "() {\n";
  if (!command.commands.empty())
    body << "  local curcontext=$curcontext state\n  local -a line commands\n  commands=(\n"
         << commandList(command) << "  )\n";
  body << "  _arguments" << (command.commands.empty() ? "" : " -C") << " \\\n";
  for (const OptionWords& option : command.options)
    body << "    " << specOf(option, path, functions) << " \\\n";
  const std::string places = command.places.empty() ? "" : functionOf(path, "_place");
  const std::string placed =
      command.places.empty() ? "" : valueFunction(places, command.places.front().value);
  functions << placed;
  if (command.commands.empty()) {
    body << "    " << shellQuoted("*: :" + (placed.empty() ? " " : places)) << "\n}\n\n";
    return functions.str() + body.str();
  }
  body << "    '1: :->first' '*:: :->rest'\n  case $state in\n    first)\n"
       << "      _describe -t commands command commands\n"
       << (placed.empty() ? "" : "      " + places + "\n") << "      ;;\n    rest)\n      case $line[1] in\n";
  for (const CommandWords& below : command.commands)
    body << "        " << below.name << ") "
         << functionOf(path.empty() ? below.name : path + " " + below.name) << " ;;\n";
  body << "      esac\n      ;;\n  esac\n}\n\n";
  return functions.str() + body.str();
}

} // namespace

std::string zshCompletion(const CommandWords& program) {
  std::ostringstream script;
  script << "#compdef limn\n# Completion of limn for zsh, made by `limn describe zsh`.\n\n";
  forEachCommand(program, [&](const CommandWords& command, const std::string& path) {
    script << commandFunction(command, path);
  });
  script << commandFunction(program, {}) << "_limn \"$@\"\n";
  return script.str();
}

} // namespace limn
