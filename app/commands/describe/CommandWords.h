// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

// The command line as a plain value: what manual page and completions are made of, so that they say what the
// program takes.
namespace limn {

/// What may stand where an option takes a value.
struct ValueWords {
  std::function<std::vector<std::string>()> words; ///< those that can be told beforehand; may be empty
  bool isFile = false;                             ///< a path of a file, on the way to which folders lie
  bool isFolder = false;
  std::vector<std::string> endings; ///< of the files, such as ".png"; empty: any
  bool isList = false;              ///< several, separated by commas
  std::optional<double> lowest;     ///< of numbers; with `highest`, both included
  std::optional<double> highest;

  std::vector<std::string> known() const { return words ? words() : std::vector<std::string>(); }
};

/// An option, or a word without a name.
struct OptionWords {
  std::vector<std::string> names; ///< with their dashes; empty for a word that is known by its place
  std::string valueName; ///< such as TEXT, or SOURCE for a word without a name; empty: takes no value
  std::string range;     ///< such as "[1 - 9]"; empty: any
  std::string what;
  bool isRequired = false;
  ValueWords value;
};

/// The program itself, or a command with those below it.
struct CommandWords {
  std::string name;
  std::string what;
  std::string footer;               ///< remarks and an example; lines
  std::vector<OptionWords> options; ///< with names
  std::vector<OptionWords> places;  ///< words without a name
  std::vector<CommandWords> commands;
};

} // namespace limn
