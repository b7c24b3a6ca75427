// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/labels/LabelNames.h"

#include "io/reading/ReadError.h"

#include <algorithm>
#include <array>
#include <string_view>

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

} // namespace

std::string volumeStem(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  for (const std::string_view ending : volumeEndings)
    if (name.size() > ending.size() && name.ends_with(ending))
      return name.substr(0, name.size() - ending.size());
  return {};
}

std::string structureName(const std::filesystem::path& file) {
  const std::string stem = volumeStem(file);
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
