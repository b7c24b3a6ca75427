// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Syntax.h"

#include "app/commands/Arguments.h"
#include "app/commands/describe/Slips.h"

#include <CLI/CLI.hpp>

namespace limn {

OptionSyntax& OptionSyntax::required(bool isRequired) {
  m_option->required(isRequired);
  return *this;
}

OptionSyntax& OptionSyntax::within(int lowest, int highest) {
  m_option->check(CLI::Range(lowest, highest));
  return *this;
}

OptionSyntax& OptionSyntax::within(double lowest, double highest) {
  m_option->check(CLI::Range(lowest, highest));
  return *this;
}

OptionSyntax& OptionSyntax::positive() {
  m_option->check(CLI::PositiveNumber);
  return *this;
}

OptionSyntax& OptionSyntax::oneOf(const std::vector<std::string>& words) {
  m_option->check(CLI::IsMember(words));
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
  const CLI::Option* const added = m_app->add_option(names, value, what);
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
  if (type.find(" in ") != std::string::npos)
    words.range = type.substr(type.rfind(" in ") + 4);
  if (const auto known = values.find(&option); known != values.end())
    words.value = known->second;
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
}

ProgramSyntax::~ProgramSyntax() = default;

CommandSyntax ProgramSyntax::words() {
  return CommandSyntax(*m_app, m_values);
}

CommandWords ProgramSyntax::described() const {
  return wordsOf(*m_app, m_values);
}

std::optional<int> ProgramSyntax::run(int argc, char** argv) {
  try {
    m_app->parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return m_app->exit(asked);
  } catch (const CLI::ParseError& error) {
    const std::string slip = slipIn(described(), {argv + 1, argv + argc});
    note(slip.empty() ? std::string(error.what()) + " (see " + m_app->get_name() + " --help)" : slip);
    return 2;
  }
  return m_app->get_subcommands().empty() ? std::nullopt : std::optional(0);
}

} // namespace limn
