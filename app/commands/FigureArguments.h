// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/FigureSettings.h"

#include <string>
#include <vector>

namespace limn {

class CommandSyntax;

/// What may be said on the command line of a figure beside its scenes. Empty or 0: not given.
struct FigureArguments {
  std::string size;
  double dotsPerInch = 0.0;
  double textPoints = 0.0;
  std::string page;
  std::vector<std::string> marks;
};

/// Adds the options; what is given is written to `arguments`, which lives until the command has run.
void addFigureOptions(CommandSyntax& command, FigureArguments& arguments);

/// The settings with everything that was given. Throws Error (usage).
FigureSettings adjusted(FigureSettings settings, const FigureArguments& arguments);

/// A figure's size as it is typed: "17cm", "17x11cm", "2000", "2000x1500" (pixels). Throws Error (usage).
FigureSettings withSize(FigureSettings settings, const std::string& text);

} // namespace limn
