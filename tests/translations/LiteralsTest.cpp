// SPDX-License-Identifier: GPL-3.0-or-later
#include "translations/Literals.h"

#include "support/Places.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <sstream>

// Whether a person could read a literal in the window that nobody can translate.
namespace limn::test {
namespace {

// What untranslated.txt lets stand: a folder, or a file and how many literals.
struct Excepted {
  std::vector<std::string> folders;
  std::map<std::string, std::size_t> files;
};

const Excepted& excepted() {
  static const Excepted all = [] {
    Excepted read;
    std::ifstream list(sourceFolder() / "tests/translations/untranslated.txt");
    for (std::string line; std::getline(list, line);) {
      if (line.empty() || line.front() == '#')
        continue;
      std::istringstream words(line);
      std::string path, reason;
      std::size_t count = 0;
      words >> path;
      if (path.ends_with('/'))
        read.folders.push_back(path);
      else if (words >> count)
        read.files[path] = count;
      std::getline(words, reason);
      EXPECT_GT(reason.size(), 10u) << "a reason is missing: " << line;
    }
    return read;
  }();
  return all;
}

TEST(Literals, whatLooksLikeLanguageIsFoundUnlessItIsMarked) {
  using Texts = std::vector<std::string>;
  EXPECT_EQ(unmarkedLiterals(R"x(label->setText(QStringLiteral("Two words"));)x"), Texts{"Two words"});
  EXPECT_EQ(unmarkedLiterals(R"x(a("One " "sentence here"); // "in a comment"
)x"),
            Texts{"One sentence here"});
  EXPECT_EQ(unmarkedLiterals(R"x(f("%1 points", '"', 1'000);)x"), Texts{"%1 points"});
  EXPECT_EQ(unmarkedLiterals(R"x(tr("Two words"); QObject::tr(
   "Two words"); translate("Context", "Two words"); Message::tr("Two words");)x"),
            Texts{});
  EXPECT_EQ(unmarkedLiterals(
                R"x({QT_TRANSLATE_NOOP("Tissue", "soft tissue")}; tr("%1 of %2", "a value, a part"))x"),
            Texts{});
  EXPECT_EQ(unmarkedLiterals(R"x(assert(x && "must be so"); setObjectName("openButton"); f("word");)x"),
            Texts{});
}

TEST(Literals, everyoneOfThemCanBeTranslatedOrHasAReason) {
  std::map<std::string, std::vector<std::string>> found;
  for (const FoundLiteral& literal : unmarkedLiteralsBelow({"app", "renderer", "widgets"}))
    if (std::ranges::none_of(excepted().folders,
                             [&](const std::string& folder) { return literal.file.starts_with(folder); }))
      found[literal.file].push_back(literal.text);
  for (const auto& [file, texts] : found) {
    const auto allowed = excepted().files.find(file);
    std::string list;
    for (const std::string& text : texts)
      list += "\n  \"" + text + "\"";
    EXPECT_EQ(texts.size(), allowed == excepted().files.end() ? 0u : allowed->second)
        << file
        << ": mark them by tr or Message::tr, or correct tests/translations/untranslated.txt:" << list;
  }
  for (const auto& [file, count] : excepted().files)
    EXPECT_TRUE(found.contains(file)) << file << " has no such literal any more: take it off the list";
}

} // namespace
} // namespace limn::test
