// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/describe/CommandWords.h"

namespace limn {

/// What to do about a word that is not known, as the end of a sentence without its stop: "did you mean
/// classic? It is one of classic, enhanced" or "choose one of classic, enhanced".
std::string choiceAmong(const std::vector<std::string>& known, const std::string& word);

/// What is wrong with arguments that were refused, where a word among them is no command or option of the
/// program: one sentence that names it, the one that was probably meant, and where help is. Empty where all
/// words are known. `arguments` without the program's name.
std::string slipIn(const CommandWords& program, const std::vector<std::string>& arguments);

} // namespace limn
