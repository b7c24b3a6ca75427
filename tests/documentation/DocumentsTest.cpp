// SPDX-License-Identifier: GPL-3.0-or-later
// What documents and comments say leads somewhere: sections, hard cases, links, paths, commands, tests.
#include "documentation/Citations.h"
#include "documentation/Commands.h"

#include <gtest/gtest.h>

#include <regex>

namespace limn {
namespace {

using test::TextFile;

constexpr std::size_t longestLine = 120;
constexpr std::size_t largestFrontPage = 9 * 1024; // bytes, for documents that are read as a whole

const test::Citable& citableHere() {
  static const test::Citable all = test::citableOf(test::fileAt("renderer/DEFINITION.md").text,
                                                   test::fileAt("renderer/stability/HARD_CASES.md").text);
  return all;
}

void expectNone(const TextFile& file, const std::vector<std::string>& faults) {
  for (const std::string& fault : faults)
    ADD_FAILURE() << file.path.string() << " " << fault;
}

bool isOfThisTest(const TextFile& file) {
  return file.path.string().starts_with("tests/documentation/");
}

TEST(Citations, everyOneResolves) {
  for (const TextFile& file : test::filesEnding({".h", ".cpp", ".inl", ".glsl", ".txt", ".md", ".json"}))
    if (!isOfThisTest(file))
      expectNone(file, test::unresolvedCitations(file.text, citableHere()));
}

TEST(Citations, everyPathInASourceExists) {
  for (const TextFile& file : test::filesEnding({".h", ".cpp", ".inl", ".glsl"}))
    if (!isOfThisTest(file))
      expectNone(file, test::missingPathsOfASource(file.text));
}

TEST(Citations, everyHardCaseThatIsDrawnIsDescribedAndTheOtherWayRound) {
  static const std::regex row(R"re(\{"H([0-9]+)",\s*")re");
  std::set<int> drawn;
  for (const TextFile& file : test::filesEnding({".cpp"}))
    if (file.path.string().starts_with("renderer/stability/"))
      for (std::sregex_iterator match(file.text.begin(), file.text.end(), row), end; match != end; ++match)
        drawn.insert(std::stoi((*match)[1]));
  EXPECT_FALSE(drawn.empty());
  EXPECT_EQ(drawn, citableHere().hardCases);
}

TEST(Documents, linksAndPathsLeadSomewhere) {
  const std::vector<TextFile> documents = test::filesEnding({".md"});
  ASSERT_GT(documents.size(), 5u);
  for (const TextFile& document : documents) {
    expectNone(document, test::brokenLinks(document));
    expectNone(document, test::missingPaths(document));
  }
}

TEST(Documents, functionsNamedWithTheirFileAreThere) {
  for (const TextFile& document : test::filesEnding({".md"}))
    expectNone(document, test::missingFunctions(document));
}

TEST(Documents, whatTheyTellToTypeExists) {
  const test::Typeable known = test::typeable();
  ASSERT_TRUE(known.commands.contains("render"));
  ASSERT_TRUE(known.options.contains("--size"));
  for (const TextFile& document : test::filesEnding({".md"}))
    expectNone(document, test::brokenCommands(document.text, known));
}

TEST(Documents, haveLinesThatFitAWindow) {
  for (const TextFile& document : test::filesEnding({".md"}))
    expectNone(document, test::longLines(document, longestLine));
}

TEST(Documents, thatAreReadAsAWholeAreShort) {
  for (const char* path : {"README.md", "ARCHITECTURE.md"})
    EXPECT_LE(test::fileAt(path).text.size(), largestFrontPage) << path;
}

} // namespace
} // namespace limn
