// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/describe/CommandWords.h"

namespace limn {

/// Of the words that are known the one that a slip of the keyboard made `word` of: by at most one letter left
/// out, added, changed or swapped with its neighbour for each three of its letters. Empty where there is
/// none.
std::string meantBy(const std::string& word, const std::vector<std::string>& known);

/// What is wrong with arguments that were refused, where a word among them is no command or option of the
/// program: one sentence that names it, the one that was probably meant, and where help is. Empty where all
/// words are known. `arguments` without the program's name.
std::string slipIn(const CommandWords& program, const std::vector<std::string>& arguments);

} // namespace limn
