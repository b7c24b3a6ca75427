// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <regex>
#include <string>

namespace limn::test {

/// Calls `found` with every match of a pattern in a text, in order.
template <class F>
void forEachMatch(const std::string& text, const std::regex& pattern, F&& found) {
  for (std::sregex_iterator match(text.begin(), text.end(), pattern), end; match != end; ++match)
    found(*match);
}

} // namespace limn::test
