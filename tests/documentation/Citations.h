// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "documentation/Tree.h"

#include <map>
#include <set>
#include <string>
#include <vector>

// What documents and comments refer to, as functions of text: each returns a sentence for every reference
// that leads nowhere, and nothing where all lead somewhere.
namespace limn::test {

/// What the definition and the list of hard cases offer to be cited.
struct Citable {
  std::map<std::string, std::set<int>> sections; ///< by document: "DEFINITION", "HARD_CASES"
  std::set<int> hardCases;
};

/// The numbers of the headings "## 7. …" and of the cases "**H7**".
Citable citableOf(const std::string& definition, const std::string& hardCases);

/// Citations such as "DEFINITION sections 1 and 2" and "H45", also where a comment breaks its line, and
/// documents named "SOMETHING.md" of which there is none.
std::vector<std::string> unresolvedCitations(const std::string& text, const Citable& citable);

/// Paths such as `tests/io/NrrdTest.cpp` in a source.
std::vector<std::string> missingPathsOfASource(const std::string& text);

/// Links to places within the project, with their headings.
std::vector<std::string> brokenLinks(const TextFile& document);

/// Files and folders between backticks; from the root, from `renderer/` or from the document's folder. Names
/// of sources may stand without their folder, or without their ending where they have one; `NAME` and `Name`
/// in a recipe stand for any.
std::vector<std::string> missingPaths(const TextFile& document);

/// Functions named with their file, as in "`lit` in `shaders/lighting.glsl`", that the file does not have.
std::vector<std::string> missingFunctions(const TextFile& document);

/// Lines of more characters than `most`.
std::vector<std::string> longLines(const TextFile& document, std::size_t most);

} // namespace limn::test
