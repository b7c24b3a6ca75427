// SPDX-License-Identifier: GPL-3.0-or-later
#include "translations/Literals.h"

#include "support/FileBytes.h"
#include "support/Places.h"

#include <algorithm>
#include <cctype>
#include <regex>

namespace limn::test {
namespace {

namespace fs = std::filesystem;

// A piece of a source: code without comments, or what stands in a literal.
struct Piece {
  bool isLiteral;
  std::string text;
};

bool startsAt(const std::string& source, std::size_t at, const char* text) {
  return source.compare(at, std::char_traits<char>::length(text), text) == 0;
}

// The end of a raw literal that begins at its quote.
std::size_t endOfRaw(const std::string& source, std::size_t quote) {
  const std::size_t open = source.find('(', quote);
  const std::string close = ")" + source.substr(quote + 1, open - quote - 1) + "\"";
  return source.find(close, open) + close.size();
}

// The end of a literal in quotes of a kind that begins at its quote.
std::size_t endOfQuoted(const std::string& source, std::size_t quote) {
  std::size_t i = quote + 1;
  while (source[i] != source[quote])
    i += source[i] == '\\' ? 2 : 1;
  return i + 1;
}

bool isDigitSeparator(const std::string& source, std::size_t i) {
  return i > 0 && std::isxdigit(static_cast<unsigned char>(source[i - 1])) != 0; // not the u of u' '
}

std::vector<Piece> piecesOf(const std::string& source) {
  std::vector<Piece> pieces;
  std::string code;
  const auto addLiteral = [&](std::string text) {
    const bool follows =
        !pieces.empty() && pieces.back().isLiteral &&
        std::all_of(code.begin(), code.end(), [](unsigned char c) { return std::isspace(c); });
    if (follows) {
      pieces.back().text += text; // the compiler joins them, too
    } else {
      pieces.push_back({false, code});
      pieces.push_back({true, std::move(text)});
    }
    code.clear();
  };
  for (std::size_t i = 0; i < source.size();) {
    if (startsAt(source, i, "//")) {
      i = std::min(source.find('\n', i), source.size());
    } else if (startsAt(source, i, "R\"")) {
      const std::size_t end = endOfRaw(source, i + 1), open = source.find('(', i);
      addLiteral(source.substr(open + 1, source.rfind(')', end) - open - 1));
      i = end;
    } else if (source[i] == '"') {
      const std::size_t end = endOfQuoted(source, i);
      addLiteral(source.substr(i + 1, end - i - 2));
      i = end;
    } else if (source[i] == '\'' && !isDigitSeparator(source, i)) {
      const std::size_t end = endOfQuoted(source, i);
      code += source.substr(i, end - i);
      i = end;
    } else {
      code += source[i++];
    }
  }
  return pieces;
}

bool looksLikeLanguage(const std::string& text) {
  static const std::regex words(
      R"([A-Za-z]{2,}[,;:.]? [A-Za-z]{2,}|[A-Za-z]{2,} %[1-9]|%[1-9] [A-Za-z]{2,})");
  return std::regex_search(text, words);
}

// Whether the code before a literal marks it, tells the compiler something, or is for programmers.
bool isMarked(const std::string& code) {
  constexpr std::size_t enough = 300; // letters before the literal
  const std::string before = code.substr(code.size() - std::min(code.size(), enough));
  static const std::regex marks(
      R"((\b(tr|translate|QT_TRANSLATE_NOOP|QT_TR_NOOP)\(\s*|\bassert\([^;]*|#\w+ [^\n]*)$)");
  return std::regex_search(before, marks);
}

} // namespace

std::vector<std::string> unmarkedLiterals(const std::string& source) {
  const std::vector<Piece> pieces = piecesOf(source);
  std::vector<std::string> found;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    if (!pieces[i].isLiteral || !looksLikeLanguage(pieces[i].text))
      continue;
    std::string before = pieces[i - 1].text;
    // The second argument of translate and of QT_TRANSLATE_NOOP.
    if (i >= 3 && pieces[i - 1].text.find_first_not_of(", \n") == std::string::npos)
      before = pieces[i - 3].text;
    if (!isMarked(before))
      found.push_back(pieces[i].text);
  }
  return found;
}

std::vector<FoundLiteral> unmarkedLiteralsBelow(const std::vector<std::string>& folders) {
  std::vector<FoundLiteral> found;
  for (const std::string& folder : folders)
    for (const auto& entry : fs::recursive_directory_iterator(sourceFolder() / folder)) {
      const fs::path& path = entry.path();
      if (path.extension() != ".cpp" && path.extension() != ".h")
        continue;
      for (const std::string& text : unmarkedLiterals(bytesOfFile(path)))
        found.push_back({fs::relative(path, sourceFolder()).generic_string(), text});
    }
  std::sort(found.begin(), found.end());
  return found;
}

} // namespace limn::test
