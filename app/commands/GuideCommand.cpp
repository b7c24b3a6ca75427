// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Arguments.h"
#include "app/commands/CommandLine.h"
#include "app/commands/Commands.h"
#include "app/commands/FontsWithoutDisplay.h"
#include "app/document/Settings.h"
#include "app/guide/GuidePage.h"
#include "io/AtomicFile.h"
#include "scene/basics/Error.h"

#include <QStringList>

#include <iostream>

namespace limn {
namespace {

struct GuideArguments {
  std::vector<std::string> words;
  std::string out;
  bool asText = false;
};

void writePage(const std::string& out) {
  if (!out.ends_with(".html"))
    throw Error(Error::Kind::usage, "The guide is written as a page; give -o a name that ends in .html.");
  const FontsWithoutDisplay fonts;
  writeFileAtomically(out, guideFile(guideChapters()).toStdString());
}

void printText(const QString& words) {
  const QString text = guideText(guideChapters(), words);
  if (text.isEmpty())
    throw Error(Error::Kind::other, "The guide says nothing of \"" + words.toStdString() + "\".");
  std::cout << text.toStdString();
}

void runGuide(const GuideArguments& arguments, const std::function<void(const std::string& words)>& show) {
  QStringList words;
  for (const std::string& word : arguments.words)
    words << QString::fromStdString(word);
  if (!arguments.out.empty())
    writePage(arguments.out);
  else if (arguments.asText || !hasDisplay())
    printText(words.join(QLatin1Char(' ')));
  else
    show(words.join(QLatin1Char(' ')).toStdString());
}

} // namespace

void addGuideCommand(CommandSyntax& root, const std::function<void(const std::string& words)>& show) {
  auto arguments = std::make_shared<GuideArguments>();
  CommandSyntax command = root.command("guide", "the guide: a window to search, a page or text");
  command.option("WORDS", arguments->words, "what to look for in it");
  command.option("-o,--output", arguments->out,
                 "write it as one HTML file with its pictures inside and a field to search");
  command.flag("--text", arguments->asText,
               "print it, or what it says of WORDS; without a display that is done anyway");
  command.footer("Example: limn guide crop box");
  command.runs([arguments, show] { runGuide(*arguments, show); });
}

} // namespace limn
