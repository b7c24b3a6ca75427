// SPDX-License-Identifier: GPL-3.0-or-later
#include "Includes.h"

#include <gtest/gtest.h>

#include <iterator>
#include <map>
#include <set>

// The folders as a graph: includes lead one way, and the link lines say the same; those of the window link
// nothing in vain.
namespace limn::test {
namespace {

namespace fs = std::filesystem;

using Names = std::set<std::string>;

// The folders, relative to the root, that each folder of the product includes from.
std::map<std::string, Names> foldersIncluded() {
  std::map<std::string, Names> folders;
  for (const char* top : {"renderer", "widgets", "app"})
    for (const Include& include : includesBelow(top))
      for (const fs::path& below : {fs::path("renderer"), fs::path()}) {
        const fs::path header = below / include.header;
        const std::string from = include.file.parent_path().string(), to = header.parent_path().string();
        if (from != to && include.header.find('/') != std::string::npos && fs::exists(sourceRoot / header))
          folders[from].insert(to);
      }
  return folders;
}

// What a library links, by the keywords of its link line.
struct LinkLine {
  std::string library;
  Names publicly, privately;
};

std::string contentOf(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// The libraries of this project that a folder's library links.
LinkLine linkLineOf(const std::string& cmake) {
  static const std::regex made(R"(add_library\((limn_\w+) (?:STATIC|INTERFACE))"), words(R"([\w:]+)");
  LinkLine line;
  std::smatch match;
  if (!std::regex_search(cmake, match, made))
    return line;
  line.library = match[1];
  const std::regex linked(R"(target_link_libraries\(\s*)" + line.library + R"(\b([^)]*)\))");
  if (!std::regex_search(cmake, match, linked))
    return line;
  const std::string arguments = match[1];
  Names* to = &line.publicly;
  for (std::sregex_iterator word(arguments.begin(), arguments.end(), words), end; word != end; ++word)
    if (word->str() == "PUBLIC" || word->str() == "PRIVATE")
      to = word->str() == "PUBLIC" ? &line.publicly : &line.privately;
    else if (word->str().starts_with("limn_") && word->str() != "limn_options")
      to->insert(word->str());
  return line;
}

// The link lines below some folders of the root, by folder.
std::map<std::string, LinkLine> linkLines(const Names& tops) {
  std::map<std::string, LinkLine> lines;
  for (const std::string& top : tops)
    for (const auto& entry : fs::recursive_directory_iterator(sourceRoot / top))
      if (entry.path().filename() == "CMakeLists.txt")
        if (LinkLine line = linkLineOf(contentOf(entry.path())); !line.library.empty())
          lines[fs::relative(entry.path().parent_path(), sourceRoot).string()] = line;
  return lines;
}

// The library that a folder belongs to: its own, or that of the nearest folder above.
std::string libraryOf(fs::path folder, const std::map<std::string, LinkLine>& lines) {
  for (; !folder.empty(); folder = folder.parent_path())
    if (const auto line = lines.find(folder.string()); line != lines.end())
      return line->second.library;
  return {};
}

std::string joined(const Names& names) {
  std::string text;
  for (const std::string& name : names)
    text += " " + name;
  return text;
}

TEST(Folders, includeEachOtherOneWay) {
  std::map<std::string, Names> folders = foldersIncluded();
  ASSERT_GT(folders.size(), 60u);
  // Take away what includes nothing that is left, until only circles and what leads to them remain.
  for (bool isSmaller = true; isSmaller;) {
    isSmaller = std::erase_if(folders, [&](const auto& folder) {
                  return std::none_of(folder.second.begin(), folder.second.end(),
                                      [&](const std::string& to) { return folders.contains(to); });
                }) > 0;
  }
  for (const auto& [folder, others] : folders)
    ADD_FAILURE() << folder << " lies on or above a circle of includes; it includes from" << joined(others);
}

TEST(Folders, linkWhatTheirSourcesInclude) {
  const std::map<std::string, LinkLine> lines = linkLines({"renderer"});
  ASSERT_GT(lines.size(), 10u);
  std::map<std::string, LinkLine> wanted;
  for (const Include& include : includesBelow("renderer")) {
    const std::string from = libraryOf(include.file.parent_path(), lines);
    const std::string to = libraryOf((fs::path("renderer") / include.header).parent_path(), lines);
    if (to.empty() || to == from || !fs::exists(sourceRoot / "renderer" / include.header))
      continue;
    const bool isHeader = include.file.extension() == ".h";
    (isHeader ? wanted[from].publicly : wanted[from].privately).insert(to);
  }
  for (const auto& [folder, line] : lines) {
    LinkLine& meant = wanted[line.library];
    for (const std::string& name : meant.publicly)
      meant.privately.erase(name);
    EXPECT_EQ(joined(line.publicly), joined(meant.publicly)) << folder << ": what its headers include";
    EXPECT_EQ(joined(line.privately), joined(meant.privately)) << folder << ": what only its sources include";
  }
}

// What is linked in vain is built for nothing, and hides what leans on what.
TEST(Folders, ofTheWindowLinkNothingThatTheyDoNotInclude) {
  const std::map<std::string, LinkLine> lines = linkLines({"renderer", "widgets", "app"});
  std::map<std::string, Names> included;
  for (const char* top : {"widgets", "app"})
    for (const Include& include : includesBelow(top))
      for (const char* below : {"renderer", ""})
        if (fs::exists(sourceRoot / below / include.header))
          included[libraryOf(include.file.parent_path(), lines)].insert(
              libraryOf((fs::path(below) / include.header).parent_path(), lines));
  int looked = 0;
  for (const auto& [folder, line] : lines) {
    if (folder.starts_with("renderer"))
      continue;
    for (const Names& names : {line.publicly, line.privately})
      for (const std::string& name : names) {
        EXPECT_TRUE(included[line.library].contains(name)) << line.library << " links " << name << " in vain";
        ++looked;
      }
  }
  EXPECT_GT(looked, 30) << "the link lines were not read";
}

} // namespace
} // namespace limn::test
