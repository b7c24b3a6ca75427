// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/ProgramRun.h"
#include "support/Shell.h"
#include "support/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

// Manual page and completions, which the program makes of its own options, read by those for whom they are
// made.
namespace limn {
namespace {

using Names = std::set<std::string>;

Names linesOf(const std::string& text) {
  Names lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.insert(line);
  return lines;
}

class Describe : public testing::Test {
protected:
  // What the program writes for one of them, kept as a file.
  std::filesystem::path described(const std::string& what) {
    const test::Outcome outcome = test::runProgram(folder.path(), "describe " + what + " --date 2026-01-31");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const std::filesystem::path file = folder.path() / ("limn." + what);
    std::ofstream(file) << outcome.out;
    return file;
  }

  std::string printed(const std::string& command) {
    const test::Said said = test::said(folder.path(), command);
    EXPECT_EQ(said.status, 0) << command << "\n" << said.text;
    return said.text;
  }

  // What bash offers where the last of the words is being typed.
  Names offeredByBash(const std::string& words) {
    const std::string script = described("bash").string();
    return linesOf(printed("bash --norc -c 'source " + script + "; COMP_WORDS=(" + words +
                           "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); $(complete -p limn | sed -n "
                           "\"s/.*-F \\([^ ]*\\).*/\\1/p\"); printf \"%s\\\\n\" \"${COMPREPLY[@]}\"'"));
  }

  Names offeredByFish(const std::string& line) {
    return linesOf(printed("fish --no-config -c 'source " + described("fish").string() + "; complete -C \"" +
                           line + "\" | string replace -r \"\\t.*\" \"\"'"));
  }

  test::TemporaryFolder folder;
};

// Commands below a command, as its help lists them.
Names commandsIn(const std::string& help) {
  Names names;
  static const std::regex section(R"(Subcommands:\n((?:  .*\n?)+))"), entry(R"((?:^|\n)  ([a-z]+))");
  std::smatch match;
  if (!std::regex_search(help, match, section))
    return names;
  const std::string list = match[1];
  for (std::sregex_iterator found(list.begin(), list.end(), entry), end; found != end; ++found)
    names.insert((*found)[1]);
  return names;
}

Names optionsIn(const std::string& help) {
  Names names;
  static const std::regex entry(R"(\n  (-[^ ]+))"), name(R"(--?[a-z][a-z-]*)");
  for (std::sregex_iterator found(help.begin(), help.end(), entry), end; found != end; ++found) {
    const std::string all = (*found)[1];
    for (std::sregex_iterator part(all.begin(), all.end(), name); part != end; ++part)
      names.insert(part->str());
  }
  return names;
}

std::string without(std::string text, const std::string& what) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at))
    text.erase(at, what.size());
  return text;
}

// The page from the heading of a command to the next one.
std::string sectionOf(const std::string& page, const std::string& heading) {
  const std::size_t start = page.find("\n" + heading + "\n");
  if (start == std::string::npos)
    return {};
  return page.substr(start, page.find("\n.S", start + 1) - start);
}

TEST_F(Describe, theManualPageTellsEveryOptionOfEveryCommand) {
  const std::string page = without(test::bytesOfFile(described("man")), "\\");
  std::vector<std::string> commands{""};
  std::size_t options = 0;
  for (std::size_t i = 0; i < commands.size(); ++i) {
    const std::string help = test::runProgram(folder.path(), commands[i] + " --help").out;
    for (const std::string& below : commandsIn(help))
      commands.push_back(commands[i] + (commands[i].empty() ? "" : " ") + below);
    const std::string section =
        sectionOf(page, commands[i].empty() ? ".SH OPTIONS" : ".SS limn " + commands[i]);
    EXPECT_FALSE(section.empty()) << commands[i];
    for (const std::string& option : optionsIn(help)) {
      EXPECT_NE(section.find("fB" + option + "fR"), std::string::npos) << commands[i] << " " << option;
      ++options;
    }
  }
  // Twelve commands, three of them below presets, with a good hundred of options.
  EXPECT_GE(commands.size(), 15u);
  EXPECT_GE(options, 100u);
}

TEST_F(Describe, theManualPageIsReadWithoutAWarning) {
  const std::string page = described("man").string();
  if (!test::isOnThePath("groff") && !test::isOnThePath("mandoc"))
    GTEST_SKIP() << "neither groff nor mandoc is installed";
  if (test::isOnThePath("groff")) {
    EXPECT_EQ(printed("groff -ww -man -Tutf8 '" + page + "' 2>&1 >/dev/null"), "");
  }
  if (test::isOnThePath("mandoc")) {
    EXPECT_EQ(printed("mandoc -T lint -W warning '" + page + "'"), "");
  }
}

TEST_F(Describe, bashOffersCommandsOptionsWordsAndFiles) {
  if (!test::isOnThePath("bash"))
    GTEST_SKIP() << "bash is not installed";
  EXPECT_EQ(offeredByBash("limn pres"), Names{"presets"});
  EXPECT_EQ(offeredByBash("limn presets \"\""), (Names{"list", "show", "convert"}));
  EXPECT_EQ(offeredByBash("limn render head.nii --samp"), Names{"--samples-spent"});
  EXPECT_EQ(offeredByBash("limn render --view le"), Names{"left"});
  EXPECT_EQ(offeredByBash("limn render --engine slices"), (Names{"slices", "slices-back-to-front"}));
  EXPECT_EQ(offeredByBash("limn render --engine cpu --model com"), Names{"compare"});
  EXPECT_EQ(offeredByBash("limn figure --marks scale,cur"), Names{"scale,curve"});
  EXPECT_TRUE(offeredByBash("limn render --preset \"CT b\"").contains("CT bone"));
  std::ofstream(folder.path() / "a.png") << 1;
  std::ofstream(folder.path() / "a.txt") << 1;
  std::filesystem::create_directory(folder.path() / "a.folder");
  EXPECT_EQ(offeredByBash("limn render --output a"), (Names{"a.png", "a.folder"}));
  EXPECT_EQ(offeredByBash("limn accuracy -o a"), Names{"a.folder"});
  EXPECT_EQ(offeredByBash("limn render a"), (Names{"a.png", "a.txt", "a.folder"}));
}

TEST_F(Describe, fishOffersCommandsOptionsWordsAndFiles) {
  if (!test::isOnThePath("fish"))
    GTEST_SKIP() << "fish is not installed";
  EXPECT_EQ(offeredByFish("limn pres"), Names{"presets"});
  EXPECT_EQ(offeredByFish("limn presets "), (Names{"list", "show", "convert"}));
  EXPECT_EQ(offeredByFish("limn render --samp"), Names{"--samples-spent"});
  EXPECT_EQ(offeredByFish("limn render --view le"), Names{"left"});
  EXPECT_EQ(offeredByFish("limn figure --marks scale,cur"), Names{"scale,curve"});
  EXPECT_TRUE(offeredByFish("limn render --preset CT").contains("CT bone"));
  std::ofstream(folder.path() / "a.png") << 1;
  std::ofstream(folder.path() / "a.txt") << 1;
  // Files with the endings come first, others after them.
  EXPECT_TRUE(offeredByFish("limn render --output a").contains("a.png"));
}

// A zsh of its own on a terminal of its own, in which lines are typed and Tab is pressed; a key of the test's
// writes down what the line has become.
constexpr const char* zshAtATerminal = R"(
zmodload zsh/zpty
cat >start.zsh <<'START'
fpath=($PWD/functions $fpath)
autoload -U compinit
compinit -u -d zcompdump
write_down() { print -r -- "$BUFFER" >>typed; BUFFER=; print DONE }
zle -N write_down
bindkey '^T' write_down
bindkey '^I' complete-word
START
zpty shell zsh -f -i
zpty -w shell 'source ./start.zsh; print REA""DY'
zpty -r shell seen '*READY*'
for line in 'limn pres' 'limn render --samp' 'limn render --view le' 'limn figure --marks scale,cur' \
    'limn render --preset CT\ bone\ a' 'limn render -o onl'; do
  zpty -n -w shell "$line"$'\t\x14'
  zpty -r shell seen '*DONE*'
done
cat typed
)";

TEST_F(Describe, zshOffersCommandsOptionsWordsAndFiles) {
  if (!test::isOnThePath("zsh"))
    GTEST_SKIP() << "zsh is not installed";
  const std::string script = described("zsh").string();
  EXPECT_EQ(printed("zsh -n '" + script + "'"), "");
  std::filesystem::create_directory(folder.path() / "functions");
  std::filesystem::copy_file(script, folder.path() / "functions/_limn");
  std::ofstream(folder.path() / "only.png") << 1;
  std::ofstream(folder.path() / "only.txt") << 1;
  std::ofstream(folder.path() / "typed.zsh") << zshAtATerminal;
  EXPECT_EQ(linesOf(printed("timeout 600 zsh -f typed.zsh")),
            (Names{"limn presets ", "limn render --samples-spent ", "limn render --view left ",
                   "limn figure --marks scale,curve,", "limn render --preset CT\\ bone\\ and\\ veil ",
                   "limn render -o only.png "}));
}

} // namespace
} // namespace limn
