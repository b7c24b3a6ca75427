// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace limn {

/// Of the words that are known the one that a slip of the keyboard made `word` of: by at most one letter left
/// out, added, changed or swapped with its neighbour for each three of its letters, whatever their case. Of a
/// name of several words one is enough, if it has three letters: "bone" means "CT bone"; the shortest such
/// name is taken. Empty where there is none.
std::string meantBy(const std::string& word, const std::vector<std::string>& known);

} // namespace limn
