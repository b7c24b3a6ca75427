// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/FigureArguments.h"

#include "app/commands/SceneArguments.h"

#include <locale>
#include <sstream>

namespace limn {
namespace {

[[noreturn]] void failSize(const std::string& text) {
  throw Error(Error::Kind::usage, "--size cannot be \"" + text +
                                      "\"; write a width or WIDTHxHEIGHT in pixels or centimetres, such as "
                                      "2000x1500, 17cm or 17x11cm.");
}

template <class Value, std::size_t count>
std::map<std::string, Value> byName(const std::array<Value, count>& values) {
  std::map<std::string, Value> words;
  for (const Value value : values)
    words.emplace(nameOf(value), value);
  return words;
}

std::vector<std::string> markWords() {
  std::vector<std::string> words = wordsOf(byName(figureMarks));
  words.insert(words.end(), {"all", "none"});
  return words;
}

} // namespace

FigureSettings withSize(FigureSettings settings, const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  settings.height.reset();
  if (!(stream >> settings.width) || !(settings.width > 0.0))
    failSize(text);
  if (stream.peek() == 'x') {
    stream.get();
    if (!(stream >> settings.height.emplace()) || !(*settings.height > 0.0))
      failSize(text);
  }
  std::string unit;
  stream >> unit;
  if (!unit.empty() && unit != "cm" && unit != "px")
    failSize(text);
  settings.unit = unit == "cm" ? FigureSettings::Unit::centimetres : FigureSettings::Unit::pixels;
  return settings;
}

FigureSettings adjusted(FigureSettings settings, const FigureArguments& arguments) {
  if (!arguments.size.empty())
    settings = withSize(settings, arguments.size);
  if (arguments.dotsPerInch > 0.0)
    settings.dotsPerInch = arguments.dotsPerInch;
  if (arguments.textPoints > 0.0)
    settings.textPoints = arguments.textPoints;
  if (!arguments.page.empty())
    settings.page = chosen(byName(figurePages), arguments.page, "--page");
  const bool isOneWord = arguments.marks.size() == 1;
  if (isOneWord && (arguments.marks[0] == "all" || arguments.marks[0] == "none")) {
    settings.marks.fill(arguments.marks[0] == "all");
  } else if (!arguments.marks.empty()) {
    settings.marks.fill(false);
    for (const std::string& word : arguments.marks)
      settings.marks[static_cast<std::size_t>(chosen(byName(figureMarks), word, "--marks"))] = true;
  }
  return settings;
}

void addFigureOptions(CommandSyntax& command, FigureArguments& arguments) {
  command.option(
      "--size", arguments.size,
      "of the whole figure: a width or WIDTHxHEIGHT in pixels, or in centimetres: 2000x1500, 17cm, "
      "17x11cm (default: 8.5cm for one panel, 17cm for more; the height follows from the pictures)");
  command.option("--dpi", arguments.dotsPerInch, "dots per inch (default 300)")
      .within(fewestDotsPerInch, mostDotsPerInch);
  command.option("--text", arguments.textPoints, "height of the text in points (default 8)")
      .within(1.0, 200.0);
  command.option("--page", arguments.page, "white, black or transparent (PNG, TIFF, EXR, PDF)")
      .words(wordsOf(byName(figurePages)));
  command
      .option("--marks", arguments.marks,
              "all, none or a list of letters, names, orientation, scale, curve, accuracy, region, note")
      .separatedByCommas()
      .words(markWords);
}

} // namespace limn
