// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/SceneSource.h"

#include <QString>

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

/// Whether there is a display to open a window on.
bool hasDisplay();

/// Opens the guide alone, where `words` stand first if it says something of them, and runs until it closes.
void runGuideWindow(const QString& words);

/// Opens the window and runs until it closes. Returns the exit status. Throws Error (openGl) where there is
/// no display.
int runWindow(int argc, char** argv, const WindowArguments& arguments);

} // namespace limn
