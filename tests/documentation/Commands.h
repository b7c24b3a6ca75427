// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "documentation/Tree.h"

#include <set>
#include <string>
#include <vector>

// What documents tell people to type, compared with what there is.
namespace limn::test {

/// What can be typed.
struct Typeable {
  std::set<std::string> commands; ///< of the program: "render"
  std::set<std::string> options;  ///< of the program: "--size"
  std::set<std::string> targets;  ///< of the build: "limn_io_tests"
  std::vector<std::string> tests; ///< "Suite.test"; of a suite with parameters "Any/Suite.test/0"
};

/// Read from the sources of the program, the build and the tests.
Typeable typeable();

/// A sentence for each command, option, program of the build and `--gtest_filter` in a document that does not
/// exist. Looks at text between backticks and at code.
std::vector<std::string> brokenCommands(const std::string& document, const Typeable& known);

} // namespace limn::test
