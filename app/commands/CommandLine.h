// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/sources/SceneSource.h"

#include <functional>
#include <string>

namespace limn {

/// How the window starts.
struct WindowArguments {
  std::string path;       ///< what to open; empty: the empty state
  SourceOptions options;  ///< how to open it
  std::string screenshot; ///< PNG to save once the picture rests, then quit; empty: stay open
  std::string theme;      ///< "light" or "dark"; empty: as set
  std::string language;   ///< the code of one of `languagesSpoken`; empty: as set
};

/// The windows that the command line opens; they stand above it.
struct Windows {
  /// Opens the window and runs until it closes. Returns the exit status. Throws Error (openGl) where there is
  /// no display.
  std::function<int(int argc, char** argv, const WindowArguments& arguments)> run;
  /// Opens the guide alone, where `words` stand first if it says something of them, and runs until it closes.
  std::function<void(const std::string& words)> showGuide;
};

/// Runs the program for these arguments and returns its exit status: 0 done, 2 wrong usage, 3 input refused,
/// 4 no OpenGL, 1 anything else. Without a subcommand it opens the window.
int runCommandLine(int argc, char** argv, const Windows& windows);

/// Whether there is a display to open a window on.
bool hasDisplay();

/// Runs the work of a program and says in one sentence what it throws. Its exit status, as above.
int statusOf(const std::function<int()>& work);

/// Tells Qt what the program is called, for every program of ours alike: they share settings.
void nameProgram();
std::string versionOfProgram();

} // namespace limn
