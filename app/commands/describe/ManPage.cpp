// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/describe/Descriptions.h"

#include <algorithm>
#include <sstream>

namespace limn {
namespace {

// Text as roff reads it: backslashes and hyphens to be typed are escaped, a dot or quote begins no request,
// and what stands between backticks is bold.
std::string roff(const std::string& text) {
  std::string escaped;
  bool isBold = false;
  for (const char c : text) {
    if ((c == '.' || c == '\'') && (escaped.empty() || escaped.back() == '\n'))
      escaped += "\\&";
    if (c == '`')
      escaped += (isBold = !isBold) ? "\\fB" : "\\fR";
    else if (c == '\\')
      escaped += "\\e";
    else if (c == '-')
      escaped += "\\-";
    else
      escaped += c;
  }
  return escaped;
}

std::string bold(const std::string& text) {
  return "\\fB" + roff(text) + "\\fR";
}

std::string italic(const std::string& text) {
  return "\\fI" + roff(text) + "\\fR";
}

// "a value": what is to be put in, with dots where there may be several.
std::string valueOf(const OptionWords& option) {
  return option.valueName.empty() ? "" : " " + italic(option.valueName);
}

std::string entry(const OptionWords& option) {
  std::string head;
  for (const std::string& name : option.names)
    head += (head.empty() ? "" : ", ") + bold(name);
  head = head.empty() ? italic(option.valueName) : head + valueOf(option);
  std::string text = roff(option.what);
  if (!option.range.empty())
    text += "; in " + roff(option.range);
  if (option.isRequired)
    text += "; required";
  return ".TP\n" + head + "\n" + text + "\n";
}

// What is typed, in one line: "limn render SOURCE [options]".
std::string synopsis(const CommandWords& command, const std::string& path) {
  std::string line = ".B " + roff(path) + "\n";
  for (const OptionWords& place : command.places)
    line += (place.isRequired ? "" : "[") + italic(place.valueName) + (place.isRequired ? "" : "]") + "\n";
  if (!command.commands.empty() && command.places.empty())
    line += italic("COMMAND") + "\n";
  return line + "[" + italic("OPTIONS") + "]\n";
}

// Remarks line by line, since lists and examples stand in lines.
std::string remarks(const std::string& footer) {
  if (footer.empty())
    return {};
  std::istringstream lines(footer);
  std::string text = ".PP\n.nf\n";
  for (std::string line; std::getline(lines, line);)
    text += roff(line) + "\n";
  return text + ".fi\n";
}

std::string entries(const CommandWords& command) {
  std::string text;
  for (const OptionWords& place : command.places)
    text += entry(place);
  for (const OptionWords& option : command.options)
    text += entry(option);
  return text;
}

const char* const exitStatus = R"(.SH EXIT STATUS
.TP
.B 0
done
.TP
.B 1
something else failed; the message says what
.TP
.B 2
the words of the command are wrong
.TP
.B 3
the input was refused
.TP
.B 4
there is no OpenGL, or no display for a window
)";

} // namespace

std::string manPage(const CommandWords& program, const std::string& version, const std::string& date) {
  std::ostringstream page;
  page << ".\\\" Made by `limn describe man`.\n"
       << ".TH LIMN 1 \"" << date << "\" \"Limn " << version << "\" \"User Commands\"\n"
       << ".SH NAME\nlimn \\- shows CT and MR volumes and shapes their transfer functions\n"
       << ".SH SYNOPSIS\n"
       << synopsis(program, program.name);
  forEachCommand(program, [&](const CommandWords& command, const std::string& path) {
    page << ".br\n" << synopsis(command, program.name + " " + path);
  });
  page << ".SH DESCRIPTION\n"
       << roff(program.what) << "\n"
       << ".PP\nWithout a command a window opens.\n"
       << remarks(program.footer) << ".SH OPTIONS\n"
       << entries(program) << ".SH COMMANDS\n";
  forEachCommand(program, [&](const CommandWords& command, const std::string& path) {
    page << ".SS " << program.name << " " << path << "\n"
         << roff(command.what) << "\n"
         << entries(command) << remarks(command.footer);
  });
  page << exitStatus;
  return page.str();
}

} // namespace limn
