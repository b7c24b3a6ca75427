// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
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

} // namespace limn
