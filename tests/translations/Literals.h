// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace limn::test {

/// The string literals of C++ sources that look like language (two words beside each other, or a word and a
/// place) and are not marked for translation by tr, translate or QT_TRANSLATE_NOOP.
std::vector<std::string> unmarkedLiterals(const std::string& source);

/// An unmarked literal and the file that holds it, relative to the checkout.
struct FoundLiteral {
  std::string file;
  std::string text;
  auto operator<=>(const FoundLiteral&) const = default;
};

/// Those of all sources below folders of the checkout.
std::vector<FoundLiteral> unmarkedLiteralsBelow(const std::vector<std::string>& folders);

} // namespace limn::test
