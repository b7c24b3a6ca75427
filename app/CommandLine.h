// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace limn {

/// Runs the program for these arguments and returns its exit status: 0 done, 2 wrong usage, 3 input refused,
/// 4 no OpenGL, 1 anything else. Without a subcommand it opens the window.
int runCommandLine(int argc, char** argv);

/// Runs the work of a program and says in one sentence what it throws. Its exit status, as above.
int statusOf(const std::function<int()>& work);

/// Tells Qt what the program is called, for every program of ours alike: they share settings.
void nameProgram();
std::string versionOfProgram();

} // namespace limn
