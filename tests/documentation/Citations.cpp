// SPDX-License-Identifier: GPL-3.0-or-later
#include "documentation/Citations.h"

#include "documentation/Matches.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace limn::test {
namespace {

namespace fs = std::filesystem;

std::set<int> numbersOf(const std::string& text, const std::regex& pattern) {
  std::set<int> numbers;
  forEachMatch(text, pattern, [&](const std::smatch& match) { numbers.insert(std::stoi(match[1])); });
  return numbers;
}

// The text on one line, without the marks of comments at which it was broken.
std::string flowing(const std::string& text) {
  static const std::regex lineBreak(R"(\s*\n\s*(///?|#)?[ \t]*)");
  return std::regex_replace(text, lineBreak, " ");
}

// What is shown as code is not prose.
std::string withoutCode(const std::string& text) {
  std::istringstream lines(text);
  std::string prose;
  bool isCode = false;
  for (std::string line; std::getline(lines, line);) {
    const bool isFence = line.starts_with("```");
    if (isFence)
      isCode = !isCode;
    prose += (isCode || isFence ? "" : line) + "\n";
  }
  return prose;
}

// As web pages name a heading: lower case, hyphens for spaces, nothing else.
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (const char c : heading)
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (c == ' ')
      anchor += '-';
  return anchor;
}

bool hasHeading(const TextFile& document, const std::string& anchor) {
  static const std::regex heading(R"((^|\n)#+ ([^\n]+))");
  bool isThere = false;
  forEachMatch(document.text, heading,
               [&](const std::smatch& match) { isThere |= anchorOf(match[2]) == anchor; });
  return isThere;
}

// "a/{b,c}" as "a/b" and "a/c".
std::vector<std::string> expanded(const std::string& path) {
  const std::size_t open = path.find('{');
  const std::size_t close = path.find('}');
  if (open == std::string::npos || close == std::string::npos)
    return {path};
  std::vector<std::string> all;
  std::istringstream choices(path.substr(open + 1, close - open - 1));
  for (std::string choice; std::getline(choices, choice, ',');)
    all.push_back(path.substr(0, open) + choice + path.substr(close + 1));
  return all;
}

// A path of a recipe, such as formats/NAME/NameFile.h.
bool isPattern(const std::string& path) {
  return path.find("NAME") != std::string::npos || path.find("/Name") != std::string::npos;
}

bool isPlace(const fs::path& folder, const std::string& path) {
  static constexpr const char* endings[] = {"", ".h", ".cpp", ".glsl"};
  return std::any_of(std::begin(endings), std::end(endings),
                     [&](const char* ending) { return fs::exists(folder / (path + ending)); });
}

} // namespace

Citable citableOf(const std::string& definition, const std::string& hardCases) {
  static const std::regex heading(R"(\n## ([0-9]+)\. )");
  static const std::regex hardCase(R"(\*\*H([0-9]+)\*\*)");
  return {{{"DEFINITION", numbersOf(definition, heading)}, {"HARD_CASES", numbersOf(hardCases, heading)}},
          numbersOf(hardCases, hardCase)};
}

std::vector<std::string> unresolvedCitations(const std::string& text, const Citable& citable) {
  static const std::regex section(R"(\b([A-Z][A-Z_]{4,}) (?:section|finding)s? ([0-9]+)(?: and ([0-9]+))?)");
  static const std::regex hardCase(R"(\bH([1-9][0-9]?)\b)");
  static const std::regex document(R"(\b([A-Z][A-Z_]+\.md)\b)");
  const std::string line = flowing(text);
  std::vector<std::string> faults;
  forEachMatch(line, section, [&](const std::smatch& match) {
    const auto cited = citable.sections.find(match[1]);
    for (const std::size_t i : {2u, 3u})
      if (match[i].matched &&
          (cited == citable.sections.end() || !cited->second.contains(std::stoi(match[i]))))
        faults.push_back("cites " + match.str(1) + " section " + match.str(i) + ", which does not exist");
  });
  forEachMatch(line, hardCase, [&](const std::smatch& match) {
    if (!citable.hardCases.contains(std::stoi(match[1])))
      faults.push_back("cites the hard case " + match.str() + ", which HARD_CASES.md does not have");
  });
  forEachMatch(line, document, [&](const std::smatch& match) {
    if (!isNameOfAFile(match[1]))
      faults.push_back("names the document " + match.str(1) + ", which does not exist");
  });
  return faults;
}

std::vector<std::string> missingPathsOfASource(const std::string& text) {
  static const std::regex path(
      R"((^|[^A-Za-z0-9_/.-])((?:app|renderer|shaders|tests|widgets)/[A-Za-z0-9_/.-]+\.(?:h|cpp|glsl|md|json)))");
  static const std::regex include(R"(#include [^\n]*)"); // the compiler's business
  std::vector<std::string> faults;
  forEachMatch(std::regex_replace(text, include, ""), path, [&](const std::smatch& match) {
    if (!fs::exists(projectRoot() / match.str(2)))
      faults.push_back("names " + match.str(2) + ", which does not exist");
  });
  return faults;
}

std::vector<std::string> brokenLinks(const TextFile& document) {
  static const std::regex link(R"(\]\(([^)#\s]*)(?:#([^)\s]+))?\))");
  std::vector<std::string> faults;
  forEachMatch(withoutCode(document.text), link, [&](const std::smatch& match) {
    const std::string to = match.str(1);
    if (to.find("://") != std::string::npos)
      return;
    const fs::path place = (to.empty() ? document.path : document.path.parent_path() / to).lexically_normal();
    if (!fs::exists(projectRoot() / place))
      faults.push_back("links to " + place.string() + ", which does not exist");
    else if (match[2].matched && !hasHeading(fileAt(place), match.str(2)))
      faults.push_back("links to the heading " + match.str(2) + " of " + place.string() +
                       ", which does not exist");
  });
  return faults;
}

std::vector<std::string> missingPaths(const TextFile& document) {
  static const std::regex quoted(R"(`([A-Za-z0-9_./{},-]+)`)");
  static const std::regex source(R"([A-Za-z0-9_.]+\.(?:h|cpp|glsl|inl|qss|cmake|md))");
  const fs::path here = projectRoot() / document.path.parent_path();
  std::vector<std::string> faults;
  forEachMatch(withoutCode(document.text), quoted, [&](const std::smatch& match) {
    for (const std::string& path : expanded(match.str(1))) {
      const std::size_t slash = path.find('/');
      if (isPattern(path))
        continue;
      if (slash == std::string::npos) {
        if (std::regex_match(path, source) && !isNameOfAFile(path))
          faults.push_back("names " + path + ", which does not exist");
        continue;
      }
      const std::string first = path.substr(0, slash);
      const fs::path roots[] = {projectRoot(), projectRoot() / "renderer", here};
      const bool isOurs =
          first != "build" && std::any_of(std::begin(roots), std::end(roots), [&](const fs::path& root) {
            return !first.empty() && fs::is_directory(root / first);
          });
      if (isOurs && std::none_of(std::begin(roots), std::end(roots),
                                 [&](const fs::path& root) { return isPlace(root, path); }))
        faults.push_back("names " + path + ", which does not exist");
    }
  });
  return faults;
}

std::vector<std::string> missingFunctions(const TextFile& document) {
  static const std::regex named(R"(`(\w+)`\s+in\s+`([\w/.]+/\w+\.(?:h|cpp|glsl))`)");
  std::vector<std::string> faults;
  forEachMatch(document.text, named, [&](const std::smatch& match) {
    // Its head: a type, the name (of a member, too), arguments, and the body.
    const std::regex head(R"((^|\n) *[\w:<>,&*\s]*[\w>&*]\s+(\w+::)*)" + match.str(1) +
                          R"(\([^;{}]*\)( const| noexcept)* \{)");
    if (!std::regex_search(fileAt(match.str(2)).text, head))
      faults.push_back("says that " + match.str(1) + " is in " + match.str(2) + ", where it is not");
  });
  return faults;
}

std::vector<std::string> longLines(const TextFile& document, std::size_t most) {
  std::istringstream lines(document.text);
  std::vector<std::string> faults;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    // Bytes of UTF-8 that begin a character.
    const auto characters = static_cast<std::size_t>(
        std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }));
    if (characters > most)
      faults.push_back("line " + std::to_string(number) + " has " + std::to_string(characters) +
                       " characters of at most " + std::to_string(most));
  }
  return faults;
}

} // namespace limn::test
