// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

/// Runs the program for these arguments and returns its exit status: 0 done, 2 wrong usage, 3 input refused,
/// 4 no OpenGL, 1 anything else. Without a subcommand it opens the window.
int runCommandLine(int argc, char** argv);

} // namespace limn
