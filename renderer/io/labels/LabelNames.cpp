// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/labels/LabelNames.h"

#include "io/reading/ReadError.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>
#include <vector>

namespace limn {
namespace {

constexpr std::array<std::string_view, 6> volumeEndings{".nii.gz", ".nii", ".nrrd", ".nhdr", ".mha", ".mhd"};
constexpr std::array<std::string_view, 7> wordsForLabels{"seg",    "segmentation", "segmentations", "label",
                                                         "labels", "labelmap",     "mask"};
constexpr std::string_view betweenWords = "._ -";
constexpr std::size_t longestStructure = 200;

bool isWordForLabels(std::string_view word) {
  std::string lower(word);
  std::ranges::transform(lower, lower.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return std::ranges::find(wordsForLabels, lower) != wordsForLabels.end();
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(betweenWords);
  return first == std::string_view::npos
             ? std::string_view()
             : text.substr(first, text.find_last_not_of(betweenWords) + 1 - first);
}

// What stands between the words for labels at either end.
std::string_view withoutWordsForLabels(std::string_view name) {
  for (std::string_view left = name;; left = name) {
    name = trimmed(name);
    const std::size_t first = name.find_first_of(betweenWords), last = name.find_last_of(betweenWords);
    if (isWordForLabels(name.substr(0, first)))
      name.remove_prefix(std::min(first, name.size()));
    else if (last != std::string_view::npos && isWordForLabels(name.substr(last + 1)))
      name = name.substr(0, last);
    if (name == left)
      return name;
  }
}

// A number alone names nothing; letters of other alphabets are bytes above ASCII.
bool hasLetter(std::string_view name) {
  return std::ranges::any_of(name, [](char byte) {
    return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
           static_cast<unsigned char>(byte) > 127;
  });
}

// Shorter parts of a name stand in too many other words, and shorter numbers count ribs.
constexpr std::size_t shortestPart = 4;
constexpr std::size_t leastDigitsThatTell = 4;

// Lower case, of ASCII and of the letters of Western Europe.
std::string folded(std::string_view text) {
  std::string lower(text);
  for (std::size_t n = 0; n < lower.size(); ++n) {
    const auto byte = static_cast<unsigned char>(lower[n]);
    const auto before = n > 0 ? static_cast<unsigned char>(lower[n - 1]) : 0;
    const bool isWestern = before == 0xC3 && byte >= 0x80 && byte <= 0x9E && byte != 0x97;
    if ((byte >= 'A' && byte <= 'Z') || isWestern)
      lower[n] = static_cast<char>(byte + 0x20);
  }
  return lower;
}

bool isDigit(char byte) {
  return byte >= '0' && byte <= '9';
}

struct Word {
  std::string text;
  std::string folded;
  bool isNumber = false;
};

// Letters of other alphabets are bytes above ASCII.
std::vector<Word> wordsIn(std::string_view text) {
  std::vector<Word> words;
  const auto isPart = [](char byte) { return isDigit(byte) || hasLetter({&byte, 1}); };
  for (std::size_t first = 0; first < text.size();) {
    std::size_t end = first;
    while (end < text.size() && isPart(text[end]))
      ++end;
    if (end > first) {
      const std::string_view word = text.substr(first, end - first);
      words.push_back({std::string(word), folded(word), std::ranges::all_of(word, isDigit)});
    }
    first = end + 1;
  }
  return words;
}

// The parts of the patient's name and the patient's number, folded.
std::vector<std::string> soughtOf(const PatientLabel& patient) {
  std::vector<std::string> sought;
  for (const Word& part : wordsIn(patient.name))
    sought.push_back(part.folded);
  std::string number;
  for (const Word& part : wordsIn(patient.id))
    number += part.folded;
  if (!number.empty())
    sought.push_back(number);
  return sought;
}

// Short ones as a whole word.
bool holdsOneOf(std::string_view word, const std::vector<std::string>& sought) {
  return std::ranges::any_of(sought, [&](const std::string& part) {
    return word == part || (part.size() >= shortestPart && word.find(part) != std::string_view::npos);
  });
}

} // namespace

std::string volumeStem(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  for (const std::string_view ending : volumeEndings)
    if (name.size() > ending.size() && name.ends_with(ending))
      return name.substr(0, name.size() - ending.size());
  return {};
}

std::string withoutPatient(std::string_view name, const PatientLabel& patient) {
  const std::vector<Word> words = wordsIn(name);
  const std::vector<std::string> sought = soughtOf(patient);
  std::vector<bool> tells;
  tells.reserve(words.size());
  for (const Word& word : words)
    tells.push_back(word.isNumber
                        ? word.folded.size() >= leastDigitsThatTell || holdsOneOf(word.folded, sought)
                        : holdsOneOf(word.folded, sought));
  // A date's day and month, a UID's other parts.
  for (std::size_t n = 1; n < words.size(); ++n)
    tells[n] = tells[n] || (tells[n - 1] && words[n - 1].isNumber && words[n].isNumber);
  for (std::size_t n = words.size(); n-- > 1;)
    tells[n - 1] = tells[n - 1] || (tells[n] && words[n].isNumber && words[n - 1].isNumber);
  // What is written in several words.
  for (std::size_t first = 0; first < words.size(); ++first) {
    std::string run;
    for (std::size_t last = first; last < words.size(); ++last) {
      run += words[last].folded;
      if (std::ranges::find(sought, run) != sought.end())
        std::fill(tells.begin() + static_cast<std::ptrdiff_t>(first),
                  tells.begin() + static_cast<std::ptrdiff_t>(last) + 1, true);
    }
  }
  if (std::ranges::none_of(tells, std::identity()))
    return std::string(name);
  std::string left;
  for (std::size_t n = 0; n < words.size(); ++n)
    if (!tells[n])
      left.append(left.empty() ? "" : "_").append(words[n].text);
  return left;
}

std::string structureName(const std::filesystem::path& file, const PatientLabel& patient) {
  const std::string stem = withoutPatient(volumeStem(file), patient);
  std::string name(withoutWordsForLabels(stem));
  if (!hasLetter(name))
    return {};
  std::ranges::replace(name, '_', ' ');
  const auto doubled = std::ranges::unique(name, [](char a, char b) { return a == ' ' && b == ' '; });
  name.erase(doubled.begin(), doubled.end());
  return plainText(name, longestStructure);
}

bool isNamedLikeLabels(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  for (std::size_t first = 0; first <= name.size();) {
    const std::size_t end = std::min(name.find_first_of(betweenWords, first), name.size());
    if (isWordForLabels(std::string_view(name).substr(first, end - first)))
      return true;
    first = end + 1;
  }
  return false;
}

} // namespace limn
