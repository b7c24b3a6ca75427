// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/naming/MeantWord.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace limn {
namespace {

constexpr std::size_t leastLettersOfAName = 3;

std::string inLowerCase(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

// The optimal string alignment distance: how many letters are left out, added, changed or swapped.
std::size_t lettersApart(const std::string& a, const std::string& b) {
  std::vector<std::vector<std::size_t>> apart(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        apart[i][j] = i + j;
        continue;
      }
      const std::size_t changed = a[i - 1] == b[j - 1] ? 0 : 1;
      apart[i][j] = std::min({apart[i - 1][j] + 1, apart[i][j - 1] + 1, apart[i - 1][j - 1] + changed});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        apart[i][j] = std::min(apart[i][j], apart[i - 2][j - 2] + 1);
    }
  return apart[a.size()][b.size()];
}

std::size_t lettersFrom(const std::string& word, const std::string& name) {
  std::size_t least = lettersApart(word, name);
  std::istringstream parts(name);
  for (std::string part; parts >> part && word.size() >= leastLettersOfAName;)
    least = std::min(least, lettersApart(word, part));
  return least;
}

} // namespace

std::string meantBy(const std::string& word, const std::vector<std::string>& known) {
  std::string nearest;
  std::size_t least = word.size() / 3 + 1;
  for (const std::string& candidate : known) {
    const std::size_t apart = lettersFrom(inLowerCase(word), inLowerCase(candidate));
    if (apart < least || (apart == least && !nearest.empty() && candidate.size() < nearest.size())) {
      least = apart;
      nearest = candidate;
    }
  }
  return nearest;
}

} // namespace limn
