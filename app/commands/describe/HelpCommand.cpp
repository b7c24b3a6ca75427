// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"
#include "app/commands/Syntax.h"
#include "scene/basics/Error.h"

namespace limn {

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
