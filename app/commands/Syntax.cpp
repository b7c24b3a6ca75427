// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Syntax.h"

#include "app/commands/Arguments.h"

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
  return *this;
}

OptionSyntax& OptionSyntax::separatedByCommas() {
  m_option->delimiter(',');
  return *this;
}

CommandSyntax CommandSyntax::command(const std::string& name, const std::string& what) {
  return CommandSyntax(*m_app->add_subcommand(name, what));
}

template <class Value>
OptionSyntax CommandSyntax::option(const std::string& names, Value& value, const std::string& what) {
  return OptionSyntax(*m_app->add_option(names, value, what));
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
  return OptionSyntax(*m_app->get_option(name));
}

void CommandSyntax::needsCommand() {
  m_app->require_subcommand(1);
}

void CommandSyntax::footer(const std::string& text) {
  m_app->footer(text);
}

void CommandSyntax::runs(std::function<void()> work) {
  m_app->callback(std::move(work));
}

ProgramSyntax::ProgramSyntax(const std::string& name, const std::string& what, const std::string& version)
    : m_app(std::make_unique<CLI::App>(what, name)) {
  m_app->set_version_flag("--version", version);
}

ProgramSyntax::~ProgramSyntax() = default;

CommandSyntax ProgramSyntax::words() {
  return CommandSyntax(*m_app);
}

std::optional<int> ProgramSyntax::run(int argc, char** argv) {
  try {
    m_app->parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return m_app->exit(asked);
  } catch (const CLI::ParseError& error) {
    note(std::string(error.what()) + " (see limn --help)");
    return 2;
  }
  return m_app->get_subcommands().empty() ? std::nullopt : std::optional(0);
}

} // namespace limn
