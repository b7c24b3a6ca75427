// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace limn::test {

/// The checkout's own folder, and that of the build.
std::filesystem::path sourceFolder();
std::filesystem::path buildFolder();

/// The built program, for tests declared with PROGRAM.
std::string programPath();

} // namespace limn::test
