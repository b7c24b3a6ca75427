// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/Syntax.h"
#include "app/core/sources/SceneSource.h"

#include <optional>
#include <string>

namespace limn {

/// The options that name a source, shared by every command that takes one.
struct SourceArguments {
  std::string source;
  std::string spacing; ///< "X,Y,Z" in mm
  int series = 0;      ///< 0: not given
  std::string volume;
  double memoryMb = 0.0; ///< 0: not given
  bool quiet = false;
  std::shared_ptr<const PartWanted> part; ///< what one of several processes holds (limn-mpi); not an option
};

/// Adds the options that say how to read a source.
void addSourceOptions(CommandSyntax& command, SourceArguments& arguments);

/// Adds SOURCE and its options to a command.
void addSourceArguments(CommandSyntax& command, SourceArguments& arguments, const std::string& what);

/// What the arguments ask for. Throws Error (usage) for a spacing that is not three positive numbers.
SourceOptions sourceOptions(const SourceArguments& arguments);

/// Loads the source; what was noteworthy goes to stderr, unless the arguments ask for quiet. `bringsView`:
/// another argument says from where to look. Throws as loadScene does.
LoadedScene loadScene(const SourceArguments& arguments, const Progress& progress, bool bringsView = false);

/// Reports to stderr while it is a terminal and `quiet` is not set; without a figure where the fraction is
/// negative.
Progress terminalProgress(bool quiet);

/// The same for work of minutes: where stderr is no terminal, such as a file of what was said, it says now
/// and then how far it is.
Progress patientProgress(bool quiet);

/// "WxH" in pixels. Throws Error (usage).
glm::ivec2 parsedSize(const std::string& text);

/// Throws the Error that making the folder given by -o, or writing into it, would end with; makes nothing. To
/// be asked before long work.
void requireReportFolder(const std::filesystem::path& folder);

/// Makes the folder given by -o, with those above it. Throws Error.
void makeReportFolder(const std::filesystem::path& folder);

/// Prints one line to stderr, in the place of progress that stands there.
void note(const std::string& sentence);

} // namespace limn
