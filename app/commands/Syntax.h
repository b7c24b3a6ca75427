// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/describe/CommandWords.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace limn {

/// What may be said of an option that was added. What breaks a rule ends the program with a usage error.
class OptionSyntax {
public:
  OptionSyntax(CLI::Option& option, ValueWords& value) : m_option(&option), m_value(&value) {}

  OptionSyntax& required(bool isRequired = true);
  OptionSyntax& within(double lowest, double highest); ///< numbers, both included
  OptionSyntax& oneOf(const std::vector<std::string>& words);
  OptionSyntax& separatedByCommas();

  // No rules, but what completions offer.
  OptionSyntax& words(std::vector<std::string> known);
  OptionSyntax& words(std::function<std::vector<std::string>()> known); ///< asked only where they are needed
  OptionSyntax& file(std::vector<std::string> endings = {});            ///< such as ".png"; none: any
  OptionSyntax& folder();

private:
  CLI::Option* m_option;
  ValueWords* m_value;
};

/// What is known of the values of options.
using KnownValues = std::map<const CLI::Option*, ValueWords>;

/// The words that a command takes: its options, each bound to the variable that it fills, which has to live
/// until the command runs. A thin face of CLI11, which takes seconds to compile and stands in one source.
class CommandSyntax {
public:
  CommandSyntax(CLI::App& app, KnownValues& values) : m_app(&app), m_values(&values) {}

  /// A command below this one, such as `list` of `limn presets list`.
  CommandSyntax command(const std::string& name, const std::string& what);

  /// `names` such as "-o,--output", or "SOURCE" for a word without a name.
  template <class Value>
  OptionSyntax option(const std::string& names, Value& value, const std::string& what);
  void flag(const std::string& names, bool& value, const std::string& what);
  /// One that was added before.
  OptionSyntax added(const std::string& name);

  void needsCommand(); ///< one of those below
  void hide();         ///< from help
  void footer(const std::string& text);
  void runs(std::function<void()> work); ///< when the command was given

private:
  CLI::App* m_app;
  KnownValues* m_values;
};

/// The program's own words, and what its arguments mean.
class ProgramSyntax {
public:
  ProgramSyntax(const std::string& name, const std::string& what, const std::string& version);
  ~ProgramSyntax();

  /// To which options and commands are added.
  CommandSyntax words();

  /// All of them as a value, but for hidden commands.
  CommandWords described() const;

  /// Reads the arguments and runs the command that they name; what it throws is passed on. The exit status
  /// where nothing is left to do: a command ran, help was asked for, or the words are wrong, which is said.
  std::optional<int> run(int argc, char** argv);

private:
  std::unique_ptr<CLI::App> m_app;
  KnownValues m_values;
};

} // namespace limn
