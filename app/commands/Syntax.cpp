// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Syntax.h"

#include "app/commands/Arguments.h"
#include "app/commands/describe/Slips.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <type_traits>

namespace limn {
namespace {

std::string textOf(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", number);
  return text;
}

// "[1 - 9]"; empty where any number is taken.
std::string rangeOf(const ValueWords& value) {
  return value.lowest ? "[" + textOf(*value.lowest) + " - " + textOf(*value.highest) + "]" : "";
}

template <class Value>
struct Scalar {
  using Type = Value;
};
template <class Value>
struct Scalar<std::vector<Value>> {
  using Type = Value;
};

// What is wrong with a word that stands for a number; empty where it is one that is taken.
template <class Number>
std::string complaintAbout(const std::string& text, const ValueWords& value) {
  Number number{};
  // CLI11 takes a negative number for a very large one.
  const bool isNegative = std::is_unsigned_v<Number> && text.starts_with("-");
  const bool isNumber = !isNegative && CLI::detail::lexical_cast(text, number);
  const auto isWithin = [&] {
    const auto size = static_cast<double>(number);
    return size >= *value.lowest && size <= *value.highest;
  };
  if (isNumber && (!value.lowest || isWithin()))
    return {};
  std::string wanted = std::is_integral_v<Number> ? "a whole number" : "a number";
  if (value.lowest)
    wanted += " from " + textOf(*value.lowest) + " to " + textOf(*value.highest);
  else if (std::is_unsigned_v<Number>)
    wanted += " from 0";
  return "\"" + text + "\" is not " + wanted;
}

} // namespace

OptionSyntax& OptionSyntax::required(bool isRequired) {
  m_option->required(isRequired);
  return *this;
}

OptionSyntax& OptionSyntax::within(double lowest, double highest) {
  m_value->lowest = lowest;
  m_value->highest = highest;
  m_option->type_name(m_option->get_type_name() + " in " + rangeOf(*m_value));
  return *this;
}

OptionSyntax& OptionSyntax::oneOf(const std::vector<std::string>& words) {
  m_option->check([words](const std::string& word) {
    return std::ranges::find(words, word) != words.end()
               ? std::string()
               : "\"" + word + "\" is not known; " + choiceAmong(words, word);
  });
  return this->words(words);
}

OptionSyntax& OptionSyntax::separatedByCommas() {
  m_option->delimiter(',');
  m_value->isList = true;
  return *this;
}

OptionSyntax& OptionSyntax::words(std::vector<std::string> known) {
  return words([known = std::move(known)] { return known; });
}

OptionSyntax& OptionSyntax::words(std::function<std::vector<std::string>()> known) {
  m_value->words = std::move(known);
  return *this;
}

OptionSyntax& OptionSyntax::file(std::vector<std::string> endings) {
  m_value->isFile = true;
  m_value->endings = std::move(endings);
  return *this;
}

OptionSyntax& OptionSyntax::folder() {
  m_value->isFolder = true;
  return *this;
}

CommandSyntax CommandSyntax::command(const std::string& name, const std::string& what) {
  return CommandSyntax(*m_app->add_subcommand(name, what), *m_values);
}

template <class Value>
OptionSyntax CommandSyntax::option(const std::string& names, Value& value, const std::string& what) {
  CLI::Option* const added = m_app->add_option(names, value, what);
  using Number = typename Scalar<Value>::Type;
  if constexpr (std::is_arithmetic_v<Number>)
    added->check([known = &(*m_values)[added]](const std::string& text) {
      return complaintAbout<Number>(text, *known);
    });
  return this->added(added->get_name());
}

// The kinds of values that commands take.
template OptionSyntax CommandSyntax::option(const std::string&, std::string&, const std::string&);
template OptionSyntax CommandSyntax::option(const std::string&, int&, const std::string&);
template OptionSyntax CommandSyntax::option(const std::string&, double&, const std::string&);
template OptionSyntax CommandSyntax::option(const std::string&, std::uint64_t&, const std::string&);
template OptionSyntax CommandSyntax::option(const std::string&, std::vector<std::string>&,
                                            const std::string&);
template OptionSyntax CommandSyntax::option(const std::string&, std::vector<double>&, const std::string&);

void CommandSyntax::flag(const std::string& names, bool& value, const std::string& what) {
  m_app->add_flag(names, value, what);
}

OptionSyntax CommandSyntax::added(const std::string& name) {
  CLI::Option* const option = m_app->get_option(name);
  return OptionSyntax(*option, (*m_values)[option]);
}

void CommandSyntax::needsCommand() {
  m_app->require_subcommand(1);
}

void CommandSyntax::hide() {
  m_app->group("");
}

void CommandSyntax::footer(const std::string& text) {
  m_app->footer(text);
}

void CommandSyntax::runs(std::function<void()> work) {
  m_app->callback(std::move(work));
}

namespace {

OptionWords wordsOf(const CLI::Option& option, const KnownValues& values) {
  OptionWords words;
  for (const std::string& name : option.get_snames())
    words.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames())
    words.names.push_back("--" + name);
  words.what = option.get_description();
  words.isRequired = option.get_required();
  if (option.get_items_expected_max() == 0)
    return words;
  const std::string type = option.get_type_name();
  words.valueName = words.names.empty() ? option.get_name() : type.substr(0, type.find_first_of(" :"));
  if (const auto known = values.find(&option); known != values.end())
    words.value = known->second;
  words.range = rangeOf(words.value);
  if (!words.names.empty() && (words.value.isFile || words.value.isFolder) && !words.value.words)
    words.valueName = words.value.isFile ? "FILE" : "FOLDER";
  return words;
}

CommandWords wordsOf(const CLI::App& app, const KnownValues& values) {
  CommandWords words{app.get_name(), app.get_description(), app.get_footer(), {}, {}, {}};
  for (const CLI::Option* option : app.get_options())
    (option->nonpositional() ? words.options : words.places).push_back(wordsOf(*option, values));
  for (const CLI::App* below : app.get_subcommands([](const CLI::App*) { return true; }))
    if (!below->get_group().empty())
      words.commands.push_back(wordsOf(*below, values));
  return words;
}

} // namespace

ProgramSyntax::ProgramSyntax(const std::string& name, const std::string& what, const std::string& version)
    : m_app(std::make_unique<CLI::App>(what, name)) {
  m_app->set_version_flag("--version", version);
  // Behind a command no word is another one, such as those that the guide is asked for.
  m_app->require_subcommand(0, 1);
}

ProgramSyntax::~ProgramSyntax() = default;

CommandSyntax ProgramSyntax::words() {
  return CommandSyntax(*m_app, m_values);
}

CommandWords ProgramSyntax::described() const {
  return wordsOf(*m_app, m_values);
}

namespace {

// `limn help render` is `limn render --help`; `limn help --help` tells of help itself.
bool asksForHelp(std::vector<std::string>& arguments) {
  const auto isHelp = [](const std::string& word) { return word == "--help" || word == "-h"; };
  if (arguments.empty() || arguments.front() != "help" || std::ranges::any_of(arguments, isHelp))
    return false;
  arguments.erase(arguments.begin());
  arguments.emplace_back("--help");
  return true;
}

// The command that the words have led to, and what leads to it.
struct Reached {
  const CLI::App* command;
  std::string name;
};

Reached reached(const CLI::App& program) {
  Reached at{&program, program.get_name()};
  while (!at.command->get_subcommands().empty()) {
    at.command = at.command->get_subcommands().front();
    at.name += " " + at.command->get_name();
  }
  return at;
}

// "one SOURCE", "one IN and one OUT"; empty where a command takes no words.
std::string placesOf(const CLI::App& command) {
  std::string places;
  for (const CLI::Option* option : command.get_options())
    if (!option->nonpositional())
      places += (places.empty() ? "one " : " and one ") + option->get_name();
  return places;
}

// Words that have no place, mostly a shell's list of a folder's files.
std::string complaintAboutMore(const Reached& at, const std::vector<std::string>& arguments) {
  const std::vector<std::string> more = at.command->remaining();
  const auto found = std::ranges::find_if(
      arguments, [&](const std::string& word) { return std::ranges::find(more, word) != more.end(); });
  const std::string first = found == arguments.end() ? more.front() : *found;
  if (first.starts_with("-"))
    return at.name + " has no option " + first;
  const std::string places = placesOf(*at.command);
  std::string text = at.name + " takes " + (places.empty() ? "no words" : places) + "; " + first;
  text += more.size() == 1 ? " is one word too many"
                           : " and " + std::to_string(more.size() - 1) + " more are too many";
  std::error_code unknown;
  const std::filesystem::path folder = std::filesystem::path(first).parent_path();
  if (std::filesystem::is_regular_file(first, unknown))
    text +=
        ", and slices of one series are given by their folder, " + (folder.empty() ? "." : folder.string());
  return text;
}

std::string namesOf(const std::vector<const CLI::App*>& commands) {
  std::string names;
  for (const CLI::App* command : commands)
    names += (names.empty() ? "" : ", ") + command->get_name();
  return names;
}

// What CLI11 says, where that is not in words of its own.
std::string complaintOf(const CLI::ParseError& error, const Reached& at,
                        const std::vector<std::string>& arguments) {
  std::string said = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) && !at.command->remaining().empty())
    return complaintAboutMore(at, arguments);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error))
    return said.substr(0, said.find(':')) +
           (said.ends_with(" missing") ? " needs a value behind it" : " is there more than once");
  const auto commands = at.command->get_subcommands([](const CLI::App*) { return true; });
  if (dynamic_cast<const CLI::RequiredError*>(&error) && at.command->get_require_subcommand_min() > 0)
    return at.name + " needs one of its commands: " + namesOf(commands);
  return said;
}

} // namespace

std::optional<int> ProgramSyntax::run(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if (asksForHelp(arguments))
    if (const std::string slip = slipIn(described(), arguments); !slip.empty()) {
      note(slip);
      return 2;
    }
  try {
    m_app->parse(std::vector<std::string>(arguments.rbegin(), arguments.rend())); // as CLI11 wants them
  } catch (const CLI::Success& asked) {
    return m_app->exit(asked);
  } catch (const CLI::ParseError& error) {
    const std::string slip = slipIn(described(), arguments);
    const Reached at = reached(*m_app);
    note(slip.empty() ? complaintOf(error, at, arguments) + " (see " + at.name + " --help)" : slip);
    return 2;
  }
  return m_app->get_subcommands().empty() ? std::nullopt : std::optional(0);
}

} // namespace limn
