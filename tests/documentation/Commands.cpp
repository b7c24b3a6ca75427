// SPDX-License-Identifier: GPL-3.0-or-later
#include "documentation/Commands.h"

#include "documentation/Matches.h"

#include <algorithm>
#include <sstream>

namespace limn::test {
namespace {

std::set<std::string> wordsOf(const std::vector<TextFile>& files, const std::string& below,
                              const std::regex& pattern) {
  std::set<std::string> words;
  for (const TextFile& file : files)
    if (file.path.string().starts_with(below))
      forEachMatch(file.text, pattern, [&](const std::smatch& match) { words.insert(match[1]); });
  return words;
}

// What is typed: the blocks of code, and what stands between backticks, which may be broken at a space.
std::vector<std::string> typed(const std::string& document) {
  static const std::regex quoted("`([^`]+)`");
  std::istringstream stream(document);
  std::vector<std::string> lines;
  std::string prose;
  bool isCode = false;
  for (std::string line; std::getline(stream, line);) {
    const bool isFence = line.starts_with("```");
    if (isFence)
      isCode = !isCode;
    else if (!isCode)
      prose += line + " ";
    else if (!lines.empty() && lines.back().ends_with("\\"))
      lines.back().replace(lines.back().size() - 1, 1, line);
    else
      lines.push_back(line);
  }
  forEachMatch(prose, quoted, [&](const std::smatch& match) { lines.push_back(match[1]); });
  return lines;
}

bool isMatched(const std::string& pattern, const std::vector<std::string>& tests) {
  std::string expression;
  for (const char c : pattern)
    expression += c == '*' ? ".*" : c == '?' ? "." : c == '.' ? "\\." : std::string(1, c);
  const std::regex wanted(expression);
  return std::any_of(tests.begin(), tests.end(),
                     [&](const std::string& test) { return std::regex_match(test, wanted); });
}

void checkProgram(const std::string& line, const Typeable& known, std::vector<std::string>& faults) {
  static const std::regex program(R"((?:^|[ /])limn((?: [^|;&#]*)?))");
  static const std::regex command(R"(^ ([a-z]+)(?= |$))");
  static const std::regex option(R"( (--[a-z][a-z-]*))");
  forEachMatch(line, program, [&](const std::smatch& match) {
    const std::string words = match.str(1);
    std::smatch first;
    if (std::regex_search(words, first, command) && first[1] != "sample" &&
        !known.commands.contains(first[1]))
      faults.push_back("tells to type limn " + first.str(1) + ", which the program does not know");
    forEachMatch(words, option, [&](const std::smatch& named) {
      if (!known.options.contains(named[1]))
        faults.push_back("names the option " + named.str(1) + ", which the program does not know");
    });
  });
}

} // namespace

Typeable typeable() {
  const std::vector<TextFile> sources = filesEnding({".cpp", ".h"});
  Typeable known;
  known.commands = wordsOf(sources, "app/", std::regex(R"re(command\(\s*"([a-z]+)")re"));
  known.options = wordsOf(sources, "app/", std::regex(R"re((--[a-z][a-z-]*))re"));
  known.targets = wordsOf(filesEnding({".txt"}), "", std::regex(R"(\b(limn_[a-z0-9_]+))"));
  static const std::regex plain(R"(\bTEST(?:_F)?\(\s*(\w+),\s*(\w+)\s*\))");
  static const std::regex withParameter(R"(\bTEST_P\(\s*(\w+),\s*(\w+)\s*\))");
  for (const TextFile& file : sources) {
    forEachMatch(file.text, plain,
                 [&](const std::smatch& m) { known.tests.push_back(m.str(1) + "." + m.str(2)); });
    forEachMatch(file.text, withParameter, [&](const std::smatch& m) {
      known.tests.push_back("Any/" + m.str(1) + "." + m.str(2) + "/0");
    });
  }
  return known;
}

std::vector<std::string> brokenCommands(const std::string& document, const Typeable& known) {
  static const std::regex target(R"(\blimn_[a-z0-9_]+\b)");
  static const std::regex filter(R"(--gtest_filter=['"]?([^'"\s]+))");
  std::vector<std::string> faults;
  for (const std::string& line : typed(document)) {
    checkProgram(line, known, faults);
    forEachMatch(line, target, [&](const std::smatch& match) {
      const bool isJsonKey = match.prefix().str().ends_with('"'); // such as "limn_scene"
      if (!isJsonKey && !known.targets.contains(match.str()))
        faults.push_back("names " + match.str() + ", which is not built");
    });
    forEachMatch(line, filter, [&](const std::smatch& match) {
      std::istringstream patterns(match.str(1));
      for (std::string pattern; std::getline(patterns, pattern, ':');)
        if (!isMatched(pattern, known.tests))
          faults.push_back("names the tests " + pattern + ", of which there is none");
    });
  }
  return faults;
}

} // namespace limn::test
