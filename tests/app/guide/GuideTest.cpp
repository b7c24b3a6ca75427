// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guide/GuidePage.h"
#include "app/guide/GuideSearch.h"
#include "documentation/Matches.h"
#include "documentation/Tree.h"
#include "support/ProgramRun.h"
#include "support/TemporaryFolder.h"

#include <QFile>
#include <QImage>
#include <QTextDocument>

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

// The guide as values: its chapters, its page, and what it tells to type.

namespace limn {
namespace {

std::set<std::string> matches(const std::string& text, const char* pattern) {
  std::set<std::string> found;
  test::forEachMatch(text, std::regex(pattern), [&](const std::smatch& match) { found.insert(match[1]); });
  return found;
}

GuidePage page() {
  return guidePage(guideChapters(), [](const QString& path) { return path; });
}

TEST(Guide, holdsEveryDocumentOfItsFolder) {
  std::set<std::string> chapters;
  for (const GuideChapter& chapter : guideChapters()) {
    chapters.insert("app/guide/" + chapter.path.toStdString());
    EXPECT_TRUE(chapter.markdown.toStdString() ==
                test::fileAt("app/guide/" + chapter.path.toStdString()).text)
        << chapter.path.toStdString() << " is another in the program";
  }
  for (const test::TextFile& document : test::filesEnding({".md"})) {
    const std::string path = document.path.string();
    if (path.starts_with("app/guide/") && path != "app/guide/README.md") {
      EXPECT_TRUE(chapters.contains(path)) << path;
    }
  }
}

TEST(Guide, hasEveryPlaceAndPictureThatItNames) {
  const std::string body = page().body.toStdString();
  const std::set<std::string> places = matches(body, R"re( id="([^"]+)")re");
  const std::set<std::string> wanted = matches(body, R"re(href="#([^"]+)")re");
  EXPECT_GT(wanted.size(), 5u);
  for (const std::string& one : wanted)
    EXPECT_TRUE(places.contains(one)) << one;
  const std::set<std::string> pictures = matches(body, R"re(<img src="([^"]+)")re");
  EXPECT_GT(pictures.size(), 5u);
  for (const std::string& picture : pictures)
    EXPECT_TRUE(QFile::exists(guideResource(QString::fromStdString(picture)))) << picture;
  EXPECT_EQ(matches(body, R"re(<(img)[^>]*alt="")re").size(), 0u) << "for those who cannot see them";
}

TEST(Guide, keepsMarkdownsTextOnThePage) {
  const std::vector<GuideChapter> one{
      {"one", "one.md",
       "# One & two\n\nSee `a < b`, **bold** and [that](two/README.md#its-part).\n"
       "\n- first\n- second\n\n| a | b |\n|---|---|\n| 1 | 2 |\n\n"
       "```sh\nrun | that\nagain\n```\n\nOut: [code](../../else/x.md).\n"},
      {"two", "two/README.md", "# Two\n\n## Its part\n"}};
  const GuidePage made = guidePage(one, [](const QString& path) { return path; });
  for (const char* part :
       {"<h1 id=\"one\">One &amp; two</h1>", "<code>a &lt; b</code>", "<b>bold</b>",
        "<a href=\"#two.its-part\">that</a>", "<ul><li>first</li>\n<li>second</li>\n</ul>",
        "<tr><th>a</th><th>b</th></tr>\n<tr><td>1</td><td>2</td></tr>", "<pre>run | that\nagain\n</pre>",
        "code (<code>else/x.md</code> in Limn's source)", "<h2 id=\"two.its-part\">Its part</h2>"})
    EXPECT_TRUE(made.body.contains(QLatin1String(part))) << part << "\n" << made.body.toStdString();
  ASSERT_EQ(made.headings.size(), 3u);
  EXPECT_EQ(made.headings[2].anchor, QStringLiteral("two.its-part"));
}

TEST(Guide, isFoundByWordsBelowItsHeadings) {
  const std::vector<GuideChapter> one{
      {"one", "one.md", "# One\n\nNothing.\n\n## Crop\n\nThe box\ncuts.\n\n| the box | row |\n"}};
  EXPECT_EQ(guideText(one, QStringLiteral("BOX cuts")).toStdString(), "# One\n\n## Crop\n\nThe box\ncuts.\n");
  EXPECT_EQ(guideText(one, QStringLiteral("row")).toStdString(), "# One\n\n## Crop\n\n| the box | row |\n");
  EXPECT_EQ(guideText(one, QStringLiteral("unheard")), QString());
}

TEST(Guide, isFoundByItsHeadingsWithTheTextBelow) {
  const std::vector<GuideChapter> one{
      {"one", "one.md", "# How exact?\n\n## Briefly\n\nVery.\n\n- So.\n\n## At length\n\nToo long.\n"}};
  EXPECT_EQ(guideText(one, QStringLiteral("at length")).toStdString(),
            "# How exact?\n\n## At length\n\nToo long.\n");
  EXPECT_EQ(guideText(one, QStringLiteral("exact how")).toStdString(),
            "# How exact?\n\n## Briefly\n\nVery.\n\n- So.\n");
}

TEST(Guide, understandsQuestionsAndOtherNames) {
  EXPECT_EQ(guideWordsOf(QStringLiteral("Why is my picture grey?")).size(), 2);
  EXPECT_EQ(guideWordsOf(QStringLiteral("how do I")).size(), 3) << "nothing else is left";
  EXPECT_EQ(guideWordsOf(QStringLiteral("gradient-enhanced")).size(), 2);
  EXPECT_LT(heldName(QStringLiteral("measuring"), {QStringLiteral("ring")}).at, 0);
  EXPECT_EQ(heldName(QStringLiteral("Some rings"), guideWordsOf(QStringLiteral("ring")).front()).at, 5);
  const std::vector<GuideChapter> one{
      {"one", "one.md", "# One\n\nNothing.\n\n## The picture\n\n- Grey: no colours.\n\n- Dark.\n"}};
  for (const char* question : {"why is my picture grey?", "gray images"})
    EXPECT_EQ(guideText(one, QLatin1String(question)).toStdString(),
              "# One\n\n## The picture\n\n- Grey: no colours.\n")
        << question;
}

TEST(Guide, saysWhatToDoWhenAPictureLooksWrong) {
  for (const char* question : {"why is my picture grey", "my picture is empty", "why is it so dark",
                               "noisy picture", "ring pattern"})
    EXPECT_TRUE(guideText(guideChapters(), QLatin1String(question)).contains(QLatin1String("looks wrong")))
        << question;
  for (const char* words : {"gradient-enhanced", "gradient-enhanced shading", "film"})
    EXPECT_FALSE(guideText(guideChapters(), QLatin1String(words)).isEmpty()) << words;
}

TEST(Guide, hasNoLinksInATerminal) {
  const std::vector<GuideChapter> two{
      {"one", "one.md",
       "# One\n\nSee [the\nsecond](accuracy/README.md#its), [below](#x) or [a page](../../else/x.md).\n"},
      {"two", "accuracy/README.md", "# Two\n\n![A head](head.png)\n\n[All](../README.md)\n"}};
  EXPECT_EQ(guideText(two).toStdString(),
            "# One\n\nSee the\nsecond, below or a page (else/x.md in Limn's source).\n\n"
            "# Two\n\n[A head]\n\nAll (app/guide/README.md in Limn's source)\n");
}

class GuideCommand : public testing::Test {
protected:
  test::Outcome run(const std::string& arguments) { return test::runProgram(folder.path(), arguments); }
  test::TemporaryFolder folder;
};

TEST_F(GuideCommand, writesOnePageThatNeedsNothingElse) {
  const std::string out = (folder.path() / "guide.html").string();
  ASSERT_EQ(run("guide -o '" + out + "'").status, 0);
  const std::string file = test::bytesOfFile(out);
  EXPECT_EQ(file.find("@contents"), std::string::npos);
  for (const std::string& source : matches(file, R"re((?:src|href)="([^"]{1,40}))re"))
    EXPECT_TRUE(source.starts_with("#") || source.starts_with("data:image/png;base64,iVBOR")) << source;
  EXPECT_NE(file.find("type=\"search\""), std::string::npos);
  EXPECT_EQ(run("guide -o guide.pdf").status, 2);
}

TEST_F(GuideCommand, isTextWithoutADisplay) {
  const test::Outcome all = run("guide");
  EXPECT_EQ(all.status, 0) << all.err;
  EXPECT_NE(all.out.find("# The first five minutes"), std::string::npos);
  const test::Outcome some = run("guide crop box");
  EXPECT_EQ(some.status, 0);
  EXPECT_NE(some.out.find("B shows the crop box"), std::string::npos);
  EXPECT_LT(some.out.size(), all.out.size() / 4);
  const test::Outcome none = run("guide unheardof");
  EXPECT_EQ(none.status, 1);
  EXPECT_NE(none.err.find("says nothing of \"unheardof\""), std::string::npos) << none.err;
}

TEST_F(GuideCommand, isAskedForWordsThatAreCommandsToo) {
  for (const char* word : {"turntable", "figure", "accuracy", "film", "turntable figure"}) {
    const test::Outcome outcome = run("guide --text " + std::string(word));
    EXPECT_EQ(outcome.status, 0) << word << ": " << outcome.err;
    EXPECT_FALSE(outcome.out.empty()) << word;
  }
  EXPECT_NE(run("info phantom:8 render").err.find("render is one word too many"), std::string::npos);
}

// The first block of a shell's lines in a document.
std::string commandsOf(const std::string& document) {
  static const std::string begin = "```sh\n";
  const std::size_t from = document.find(begin) + begin.size();
  return document.substr(from, document.find("```", from) - from);
}

double meanDifference(const QImage& a, const QImage& b) {
  double sum = 0.0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x)
      sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
  return sum / (a.width() * a.height());
}

TEST_F(GuideCommand, thePapersFiguresAreWhatTheirCommandsDraw) {
  if (!std::filesystem::exists("/usr/share/doc/invesalius-examples/examples/Cranium.inv3"))
    GTEST_SKIP() << "the sample head (package invesalius-examples) is not installed";
  std::ofstream(folder.path() / "commands.sh") << commandsOf(test::fileAt("app/guide/paper.md").text);
  const std::string line = "cd '" + folder.path().string() + "' && HOME=$PWD PATH=\"" +
                           std::filesystem::path(test::programPath()).parent_path().string() +
                           ":$PATH\" sh -e commands.sh 2>errors";
  ASSERT_EQ(std::system(line.c_str()), 0) << test::bytesOfFile(folder.path() / "errors");
  for (const char* name : {"front.png", "side.png"}) {
    const QImage printed(guideResource(QStringLiteral("figures/") + QLatin1String(name)));
    const QImage drawn(QString::fromStdString((folder.path() / name).string()));
    ASSERT_FALSE(printed.isNull());
    ASSERT_EQ(drawn.size(), printed.size());
    // Engines differ by less, the text of their accuracy included.
    EXPECT_LT(meanDifference(printed, drawn), 1.0) << name << " is out of date; ./dev guide draws it anew";
  }
}

// Paragraphs, points of lists, rows of tables.
std::vector<std::string> piecesOf(const std::string& document) {
  static const std::regex border(R"(\n\n|\n- |\n\|)");
  return {std::sregex_token_iterator(document.begin(), document.end(), border, -1), {}};
}

// Each option is one of a command that its paragraph names, by that command's own --help.
TEST_F(GuideCommand, everyOptionThatDocumentsNameIsInTheHelpOfItsCommand) {
  const std::set<std::string> commands = matches(run("--help").out, R"(\n  ([a-z]+) )");
  ASSERT_TRUE(commands.contains("render") && commands.contains("guide"));
  std::map<std::string, std::string> helps;
  const auto helpOf = [&](const std::string& command) -> const std::string& {
    std::string& help = helps[command];
    if (help.empty())
      help = run(command + " --help").out;
    return help;
  };
  int options = 0;
  for (const test::TextFile& document : test::filesEnding({".md"})) {
    const std::string path = document.path.string();
    if (!path.starts_with("app/guide/") && path != "README.md")
      continue;
    for (const std::string& piece : piecesOf(document.text)) {
      std::string help;
      for (const std::string& command :
           matches(piece, R"((?:^|[^\w./-])limn ((?:presets (?:list|show|convert))|[a-z]+))"))
        help += helpOf(commands.contains(command.substr(0, command.find(' '))) ? command : "");
      if (help.empty())
        continue;
      if (piece.find("window") != std::string::npos)
        help += helpOf("");
      for (const std::string& option : matches(piece, R"([ `](--[a-z][a-z-]*))")) {
        ++options;
        EXPECT_TRUE(std::regex_search(help, std::regex(option + "\\b(?!-)"))) << path << ": " << option;
      }
    }
  }
  EXPECT_GT(options, 60);
}

} // namespace
} // namespace limn
