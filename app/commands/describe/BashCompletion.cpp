// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/describe/Descriptions.h"

#include <sstream>

namespace limn {
namespace {

// What the tables below are read with. Words may hold spaces: readline quotes what it inserts, and quotes and
// backslashes of what was typed are taken away before words are compared.
const char* const bashReader = R"sh(
# Adds the words of "$@" that begin with what was typed, after those of a list that were typed before.
_limn_words() {
  local before= part=$typed word
  if [[ $list ]]; then
    part=${typed##*,}
    before=${typed%"$part"}
  fi
  for word; do
    [[ $word == "$part"* && ,$before != *,"$word",* ]] && COMPREPLY+=("$before$word")
  done
}

# Adds folders, and files with one of the endings.
_limn_files() {
  local path
  while IFS= read -r path; do
    if [[ -d ${path/#\~\//$HOME/} ]]; then
      COMPREPLY+=("$path")
    elif [[ $kind == file ]]; then
      [[ ! $endings || ${path,,} =~ ($endings)$ ]] && COMPREPLY+=("$path")
    fi
  done < <(compgen -f -- "$typed")
  compopt -o filenames 2>/dev/null
}

_limn() {
  local command= typed=${COMP_WORDS[COMP_CWORD]} option= word i
  local -a words commands options
  local kind= endings= list=
  typed=${typed#[\"\']}
  typed=${typed//\\/}
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; i++)); do
    word=${COMP_WORDS[i]}
    if [[ $option ]]; then
      option=
    elif [[ $word == -* ]]; then
      _limn_value "$command" "$word" && option=$word
    else
      _limn_command "$command" "$word"
    fi
  done
  words=() kind= endings= list=
  if [[ $option ]]; then
    _limn_value "$command" "$option"
  elif [[ $typed == -* ]]; then
    _limn_options "$command"
    _limn_words "${options[@]}"
    return
  else
    _limn_below "$command"
    _limn_words "${commands[@]}"
    _limn_value "$command" ''
  fi
  _limn_words "${words[@]}"
  [[ $kind ]] && _limn_files
  ((${#words[@]})) && compopt -o filenames 2>/dev/null
  [[ $list ]] && compopt -o nospace 2>/dev/null
}
complete -F _limn limn
)sh";

// An ending as a regular expression.
std::string pattern(const std::vector<std::string>& endings) {
  std::string text;
  for (const std::string& ending : endings) {
    text += text.empty() ? "" : "|";
    for (const char c : ending) {
      if (c == '.')
        text += '\\';
      text += c;
    }
  }
  return text;
}

// The line of the table of values: `'render' '--engine') words=(…) kind=file endings='…' ;;`
std::string valueLine(const std::string& path, const std::vector<std::string>& names,
                      const ValueWords& value) {
  std::string line;
  for (const std::string& name : names)
    line.append(line.empty() ? "    " : " | ")
        .append(shellQuoted(std::string(path).append(":").append(name)));
  line += ") words=(" + shellQuoted(value.known()) + ")";
  if (value.isFile || value.isFolder)
    line += value.isFile ? " kind=file" : " kind=folder";
  if (!value.endings.empty())
    line += " endings=" + shellQuoted(pattern(value.endings));
  return line + (value.isList ? " list=yes" : "") + " ;;\n";
}

struct BashTables {
  std::ostringstream values, options, below, commands;
};

void addTo(BashTables& tables, const CommandWords& command, const std::string& path) {
  std::vector<std::string> options, names;
  for (const OptionWords& option : command.options) {
    options.insert(options.end(), option.names.begin(), option.names.end());
    if (!option.valueName.empty())
      tables.values << valueLine(path, option.names, option.value);
  }
  for (const CommandWords& below : command.commands) {
    names.push_back(below.name);
    tables.commands << "    " << shellQuoted(path + ":" + below.name)
                    << ") command=" << shellQuoted(path.empty() ? below.name : path + " " + below.name)
                    << " ;;\n";
  }
  // Of several words without a name the first tells what the others may be.
  if (!command.places.empty())
    tables.values << valueLine(path, {""}, command.places.front().value);
  tables.options << "    " << shellQuoted(path) << ") options=(" << shellQuoted(options) << ") ;;\n";
  tables.below << "    " << shellQuoted(path) << ") commands=(" << shellQuoted(names) << ") ;;\n";
}

} // namespace

std::string bashCompletion(const CommandWords& program) {
  BashTables tables;
  addTo(tables, program, {});
  forEachCommand(program,
                 [&](const CommandWords& command, const std::string& path) { addTo(tables, command, path); });
  return "# Completion of limn for bash, made by `limn describe bash`.\n\n"
         "# What may stand behind an option of a command, or without a name; fails where nothing may.\n"
         "_limn_value() {\n  case \"$1:$2\" in\n" +
         tables.values.str() +
         "    *) return 1 ;;\n  esac\n}\n\n# The command that a word leads to, if any.\n"
         "_limn_command() {\n  case \"$1:$2\" in\n" +
         tables.commands.str() + "  esac\n}\n\n_limn_options() {\n  case \"$1\" in\n" + tables.options.str() +
         "  esac\n}\n\n_limn_below() {\n  case \"$1\" in\n" + tables.below.str() + "  esac\n}\n" + bashReader;
}

} // namespace limn
