// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"
#include "app/commands/SceneArguments.h"
#include "app/commands/Syntax.h"
#include "app/commands/describe/Descriptions.h"
#include "scene/basics/Error.h"

#include <iostream>

namespace limn {
namespace {

struct DescribeArguments {
  std::string what;
  std::string date;
};

std::string described(const ProgramSyntax& program, const DescribeArguments& arguments,
                      const std::string& version) {
  const CommandWords words = program.described();
  if (arguments.what == "man")
    return manPage(words, version, arguments.date);
  const std::map<std::string, std::string (*)(const CommandWords&)> shells{
      {"bash", bashCompletion}, {"fish", fishCompletion}, {"zsh", zshCompletion}};
  return chosen(shells, arguments.what, "The shell")(words);
}

} // namespace

void addDescribeCommand(CommandSyntax& root, const ProgramSyntax& program, const std::string& version) {
  auto arguments = std::make_shared<DescribeArguments>();
  CommandSyntax command = root.command("describe", "this command line, for the system's help and shells");
  command.hide();
  command.option("WHAT", arguments->what, "man, bash, zsh or fish")
      .required()
      .oneOf({"man", "bash", "zsh", "fish"});
  command.option("--date", arguments->date, "of the manual page, YYYY-MM-DD");
  command.footer("Example: limn describe man | man -l -");
  command.runs([arguments, &program, version] { std::cout << described(program, *arguments, version); });
}

// It stands here to be listed and completed: the words that follow it are read as those of the command.
void addHelpCommand(CommandSyntax& root, const ProgramSyntax& program) {
  CommandSyntax command = root.command("help", "what the program takes, or one of its commands");
  auto words = std::make_shared<std::vector<std::string>>();
  command.option("COMMAND", *words, "such as render, or presets convert").words([&program] {
    std::vector<std::string> names;
    for (const CommandWords& known : program.described().commands)
      names.push_back(known.name);
    return names;
  });
  command.footer("Example: limn help render");
  command.runs([words] {
    throw Error(Error::Kind::usage, "Help stands in front of everything else, such as: limn help render");
  });
}

} // namespace limn
