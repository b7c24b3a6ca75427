// SPDX-License-Identifier: GPL-3.0-or-later
// The checks of documents fail where something is broken.
#include "documentation/Citations.h"
#include "documentation/Commands.h"

#include <gtest/gtest.h>

namespace limn {
namespace {

using Faults = std::vector<std::string>;

const test::Citable citable = test::citableOf("# Title\n\n## 1. The volume\n\n## 2. The gradient\n",
                                              "# Title\n\n## 1. Drivers\n\n**H1** Zero.\n\n**H12** Far.\n");

TEST(BrokenCitations, ofSectionsAreNamed) {
  EXPECT_EQ(test::unresolvedCitations("// DEFINITION section 2, sections 1 and 2\n", citable), Faults{});
  EXPECT_EQ(test::unresolvedCitations("/// The gradient (DEFINITION\n/// section 3).\n", citable),
            Faults{"cites DEFINITION section 3, which does not exist"});
  EXPECT_EQ(test::unresolvedCitations("// DEFINITION sections 2 and 7", citable),
            Faults{"cites DEFINITION section 7, which does not exist"});
  EXPECT_EQ(test::unresolvedCitations("// RENDERING section 1", citable),
            Faults{"cites RENDERING section 1, which does not exist"});
}

TEST(BrokenCitations, ofHardCasesAndDocumentsAreNamed) {
  EXPECT_EQ(test::unresolvedCitations("// H1 and H12, but H1_segment is another\n", citable), Faults{});
  EXPECT_EQ(test::unresolvedCitations("// H2: powers", citable),
            Faults{"cites the hard case H2, which HARD_CASES.md does not have"});
  EXPECT_EQ(test::unresolvedCitations("# see NUMERICS.md and README.md", citable),
            Faults{"names the document NUMERICS.md, which does not exist"});
}

TEST(BrokenPaths, inSourcesAreNamed) {
  EXPECT_EQ(test::missingPathsOfASource("// tests/documentation/Tree.h\n#include \"app/Nothing.h\""),
            Faults{});
  EXPECT_EQ(test::missingPathsOfASource("// as in tests/documentation/Forest.h"),
            Faults{"names tests/documentation/Forest.h, which does not exist"});
}

TEST(BrokenPaths, inDocumentsAreNamed) {
  const auto faults = [](const std::string& text) { return test::missingPaths({"tests/README.md", text}); };
  EXPECT_EQ(
      faults("`documentation/Tree` `tests/{documentation,support}/` `Tree.cpp` `build/release/limn` `a/b` "
             "`tests/NAME/NameTest.cpp`"),
      Faults{});
  EXPECT_EQ(faults("```\n`tests/nowhere/`\n```\n"), Faults{});
  EXPECT_EQ(faults("`tests/{documentation,nowhere}/`"), Faults{"names tests/nowhere/, which does not exist"});
  EXPECT_EQ(faults("`Forest.cpp`"), Faults{"names Forest.cpp, which does not exist"});
}

TEST(BrokenLinks, areNamed) {
  const auto faults = [](const std::string& text) {
    return test::brokenLinks({"renderer/stability/HARD_CASES.md", text});
  };
  EXPECT_EQ(faults("[a](../DEFINITION.md#7-the-integral) [b](https://example.org/x)"), Faults{});
  EXPECT_EQ(faults("[a](DEFINITION.md)"),
            Faults{"links to renderer/stability/DEFINITION.md, which does not exist"});
  EXPECT_EQ(faults("[a](../DEFINITION.md#70-nothing)"),
            Faults{"links to the heading 70-nothing of renderer/DEFINITION.md, which does not exist"});
}

TEST(BrokenFunctions, areThoseThatTheFileDoesNotHave) {
  const auto faults = [](const std::string& text) { return test::missingFunctions({"README.md", text}); };
  EXPECT_EQ(faults("`lit` in `shaders/lighting.glsl` and `filesEnding` in\n`tests/documentation/Tree.cpp`"),
            Faults{});
  EXPECT_EQ(faults("`highlit` in `shaders/lighting.glsl`"),
            Faults{"says that highlit is in shaders/lighting.glsl, where it is not"});
  EXPECT_EQ(faults("`blinnTerm` in `shaders/lighting.glsl`").size(), 1u) << "it is only called there";
}

TEST(BrokenLines, areTheLongOnes) {
  const std::string umlauts(120, 'x');
  EXPECT_EQ(test::longLines({"README.md", umlauts + "\n" + std::string(60, 'x') + "µ°\n"}, 120), Faults{});
  EXPECT_EQ(test::longLines({"README.md", "\n" + umlauts + "µ\n"}, 120),
            Faults{"line 2 has 121 characters of at most 120"});
}

TEST(BrokenCommands, areNamed) {
  const test::Typeable known{{"render"}, {"--size"}, {"limn_io_tests"}, {"Suite.holds", "Any/Case.holds/0"}};
  EXPECT_EQ(test::brokenCommands(
                "`limn render A --size 2x2 -o B` and `limn_io_tests --gtest_filter='*Case*:Suite.*'`", known),
            Faults{});
  EXPECT_EQ(test::brokenCommands("`limn paint A`", known),
            Faults{"tells to type limn paint, which the program does not know"});
  EXPECT_EQ(test::brokenCommands("```\nbuild/release/limn render A \\\n  --sise 2\n```", known),
            Faults{"names the option --sise, which the program does not know"});
  EXPECT_EQ(test::brokenCommands("`limn_oi_tests`", known),
            Faults{"names limn_oi_tests, which is not built"});
  EXPECT_EQ(test::brokenCommands("`{\"limn_oi\": 1}`", known), Faults{}) << "a key of a file";
  EXPECT_EQ(test::brokenCommands("`limn_io_tests --gtest_filter='Other*'`", known),
            Faults{"names the tests Other*, of which there is none"});
}

} // namespace
} // namespace limn
