// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace limn {

/// Text with the characters that HTML reserves replaced.
std::string escapedHtml(const std::string& text);

/// A row of a table, its cells escaped; `kind` becomes its class, `tag` is "td" or "th".
std::string htmlRow(const std::vector<std::string>& cells, const std::string& kind = {},
                    const char* tag = "td");

/// A whole page in the look of the program's reports; `body` is HTML, `style` is added to the common one.
std::string htmlPage(const std::string& title, const std::string& body, const std::string& style = {});

} // namespace limn
