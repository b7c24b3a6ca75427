// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <filesystem>
#include <vector>

namespace limn::test {

/// A string of the program in a list of words (Qt's .ts).
struct Word {
  QString context;
  QString source;
  QString translation; ///< empty where nobody has translated it
  bool isFinished = false;
};

/// The words of a list. Throws std::runtime_error where it is none.
std::vector<Word> wordsIn(const std::filesystem::path& list);

/// The German list of the checkout.
const std::vector<Word>& germanWords();

/// How the program is searched for strings: what lupdate finds, and what it complains of.
struct Search {
  std::vector<Word> found;
  QString complaints;
};
const Search& stringsOfTheSources();

/// A word for the text of a failure.
std::string described(const Word& word);

} // namespace limn::test
