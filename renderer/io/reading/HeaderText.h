// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace limn {

/// The text without white space at its ends.
std::string_view trimmed(std::string_view text);

/// The text in lower-case ASCII letters.
std::string lowerCase(std::string_view text);

/// The words between white space.
std::vector<std::string> words(std::string_view text);

/// The whole of a text as a number in the C locale, whatever the window system sets; "nan" and "inf" too.
/// Nothing where it is none.
std::optional<double> numberIn(std::string_view text);

/// Every word as a number in the C locale, "nan" and "inf" too. Throws Error, naming `file`, where one is
/// no number.
std::vector<double> numbers(const std::filesystem::path& file, std::string_view text);

/// One number. Throws Error, naming `file`.
double number(const std::filesystem::path& file, std::string_view text);

/// The names of the slices of a folder, to tell a lost slice by its name from a foreign file.
class NameLikeness {
public:
  /// Adds the name of a slice.
  void add(const std::filesystem::path& slice);

  /// Whether a file is called as a slice is: the same letters around other numbers, or the same ending (one
  /// of letters). Hidden files never are, because systems leave such beside the files they copy.
  bool isLike(const std::filesystem::path& file) const;

private:
  std::set<std::string> m_patterns;
  std::set<std::string> m_endings;
};

} // namespace limn
