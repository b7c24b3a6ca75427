// SPDX-License-Identifier: GPL-3.0-or-later
#include "Includes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <sstream>

// Who may include whom: what the table in ARCHITECTURE.md says, and nothing else. Link lines enforce most of
// it; includes that need no linking are caught here.
namespace limn {
namespace {

namespace fs = std::filesystem;

const fs::path& root = test::sourceRoot;

/// The rows of the table: folders, relative to the root, by what each may include, in the words of the table.
using Table = std::map<std::string, std::set<std::string>>;

std::vector<std::string> cellsOf(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t begin = 1;
  for (std::size_t end; (end = line.find('|', begin)) != std::string::npos; begin = end + 1)
    cells.push_back(line.substr(begin, end - begin));
  return cells;
}

// The words of what a cell shows as code, whether each by itself or several with spaces between.
std::set<std::string> wordsIn(const std::string& cell) {
  static const std::regex code("`([^`]+)`");
  std::set<std::string> words;
  for (std::sregex_iterator span(cell.begin(), cell.end(), code), end; span != end; ++span) {
    std::istringstream text((*span)[1]);
    words.insert(std::istream_iterator<std::string>(text), {});
  }
  return words;
}

Table tableOfRooms() {
  std::ifstream page(root / "ARCHITECTURE.md");
  Table table;
  bool isTree = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("## "))
      isTree = line == "## The tree";
    if (!isTree || !line.starts_with("| `"))
      continue;
    const std::vector<std::string> cells = cellsOf(line);
    for (const std::string& folder : wordsIn(cells.at(0)))
      table[folder] = wordsIn(cells.at(2));
  }
  return table;
}

bool isWithin(const std::string& folder, const std::string& other) {
  return folder == other || folder.starts_with(other + "/");
}

// The row that a folder belongs to: its own, or that of the nearest folder above.
std::optional<std::string> rowOf(fs::path folder, const Table& table) {
  for (; !folder.empty(); folder = folder.parent_path())
    if (table.contains(folder.string()))
      return folder.string();
  return std::nullopt;
}

// What a word of a row means: libraries, or folders; `gl` is renderer/gl, `theme` widgets/theme, and `planes`
// in a row of widgets both the slices as values and their widgets.
std::vector<std::string> meantBy(const std::string& word, const std::string& row) {
  if (word == "Qt" || word == "OpenGL" || word == "files")
    return {word};
  std::vector<std::string> folders;
  for (const std::string& folder : {"renderer/" + word, "widgets/" + word, "app/" + word, word})
    if (fs::is_directory(root / folder))
      folders.push_back(folder);
  EXPECT_FALSE(folders.empty()) << "ARCHITECTURE.md: what is `" << word << "` in the row of " << row << "?";
  return folders;
}

// What an include leads to: a folder of the project, the name of a set of libraries, or nothing to be asked
// about.
std::string targetOf(const std::string& header) {
  for (const fs::path& below : {fs::path("renderer"), fs::path()})
    if (header.find('/') != std::string::npos && fs::exists(root / below / header))
      return (below / header).parent_path().string();
  static const std::regex qt("^(Q[A-Z]|Qt)"), openGl("^epoxy"),
      files("^(vtk|itk|gdcm|dcmtk|OpenImageIO|nlohmann|json|pugixml|archive|tiff|png|zlib|QJson|QXml|QDom)");
  return std::regex_search(header, files)    ? "files"
         : std::regex_search(header, qt)     ? "Qt"
         : std::regex_search(header, openGl) ? "OpenGL"
                                             : "";
}

// `renderer`, `widgets` and folders of rows stand for all below them, but `widgets` in a row of widgets for
// what stands there itself, because its rooms are told apart.
bool covers(const std::string& word, const std::string& target, const std::string& row) {
  if (word == "widgets" && row.starts_with("widgets"))
    return target == word;
  const std::vector<std::string> folders = meantBy(word, row);
  return std::any_of(folders.begin(), folders.end(),
                     [&](const std::string& folder) { return isWithin(target, folder); });
}

TEST(Layering, holdsWhatTheTableAllows) {
  const Table table = tableOfRooms();
  ASSERT_GT(table.size(), 30u) << "the table was not read";
  std::map<std::string, std::set<std::string>> used; // words, by row
  for (const char* top : {"renderer", "widgets", "app"})
    for (const test::Include& include : test::includesBelow(top)) {
      const std::string folder = include.file.parent_path().string(), target = targetOf(include.header);
      const std::optional<std::string> row = rowOf(folder, table);
      ASSERT_TRUE(row) << folder << " has no row in ARCHITECTURE.md, and none of those above it has";
      const bool isRow = *row != "widgets" && *row != "app";
      EXPECT_TRUE(isRow || folder == *row) << folder << " has no row in ARCHITECTURE.md";
      if (target.empty() || rowOf(target, table) == row || (target.starts_with("renderer/scene") && isRow))
        continue;
      bool isAllowed = *row == "app" && target.starts_with("app/");
      for (const std::string& word : table.at(*row))
        if (covers(word, target, *row)) {
          isAllowed = true;
          used[*row].insert(word);
        }
      EXPECT_TRUE(isAllowed || target.starts_with("renderer/scene"))
          << include.file << " includes " << include.header
          << ", which the table in ARCHITECTURE.md does not allow";
    }
  for (const auto& [row, words] : table) {
    EXPECT_TRUE(fs::is_directory(root / row)) << row;
    for (const std::string& word : words)
      EXPECT_TRUE(used[row].contains(word) || row == "app") << row << " is allowed `" << word << "` in vain";
  }
}

// Who is told apart within a room.
TEST(Layering, formatsAreReadByThemselves) {
  const auto expectOnly = [](const fs::path& folder, const std::string& pattern, const std::string& why) {
    const std::vector<test::Include> includes = test::includesBelow(folder);
    EXPECT_FALSE(includes.empty()) << folder;
    const std::regex forbidden(pattern);
    for (const test::Include& include : includes)
      EXPECT_FALSE(std::regex_search(include.header, forbidden))
          << include.file << " includes " << include.header << ": " << why;
  };
  expectOnly("renderer/io/reading", "^io/(?!reading/)", "what readers share stands below them");
  expectOnly("renderer/io/dicom", "^io/(?!(reading|dicom)/)", "DICOM is read by itself");
  for (const auto& room : fs::directory_iterator(root / "renderer/io/formats"))
    if (room.is_directory())
      expectOnly(fs::relative(room.path(), root),
                 "^io/(?!reading/|openimageio/|formats/(voxels|" + room.path().filename().string() + ")/)",
                 "a format is read by itself");
  expectOnly("widgets/view/pictures", "^Q(Widget|OpenGLWidget|Application)|^widgets/view/(?!pictures/)",
             "pictures are drawn without a window");
}

// What clang-tidy looks for in sources that are read by themselves (bugprone-suspicious-include): units
// include theirs.
TEST(Sources, includeNoOthers) {
  for (const char* folder : {"renderer", "widgets", "app", "tests"})
    for (const test::Include& one : test::includesBelow(folder))
      EXPECT_FALSE(one.header.ends_with(".cpp")) << one.file << ": " << one.header;
}

TEST(Sources, carryTheirLicence) {
  for (const char* folder : {"renderer", "widgets", "app", "tests", "shaders"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".h" && extension != ".cpp" && extension != ".glsl")
        continue;
      std::ifstream file(entry.path());
      std::string first;
      std::getline(file, first);
      EXPECT_NE(first.find("SPDX-License-Identifier: GPL-3.0-or-later"), std::string::npos) << entry.path();
    }
}

} // namespace
} // namespace limn
