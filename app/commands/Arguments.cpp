// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Arguments.h"

#include "io/AtomicFile.h"
#include "scene/basics/Error.h"

#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <memory>
#include <sstream>

namespace limn {

namespace fs = std::filesystem;

namespace {

constexpr const char* clearedLine = "\r\033[K";

[[noreturn]] void failFolder(const fs::path& folder, const std::string& why) {
  std::error_code unknown;
  throw Error(Error::Kind::other, "The folder " + folder.string() + " cannot be " +
                                      (fs::is_directory(folder, unknown) ? "written to" : "made") + " (" +
                                      why + "); choose another one with -o.");
}

} // namespace

void addSourceOptions(CommandSyntax& command, SourceArguments& arguments) {
  command.option("--spacing", arguments.spacing, "voxel spacing X,Y,Z in mm, for files that name none");
  command
      .option("--series", arguments.series, "number of the series in a DICOM folder, as `limn info` lists it")
      .within(1, 100000);
  command.option("--volume", arguments.volume, "where the volume of a scene or picture is now").file();
  command
      .option("--memory", arguments.memoryMb,
              "MB of memory to keep for itself (default: half of what is free); larger volumes stay on disk")
      .within(1.0, 1e9);
}

void addSourceArguments(CommandSyntax& command, SourceArguments& arguments, const std::string& what) {
  command.option("SOURCE", arguments.source, what).required().words({"sample"}).file();
  addSourceOptions(command, arguments);
  command.flag("--quiet", arguments.quiet, "no progress and no remarks on stderr");
}

SourceOptions sourceOptions(const SourceArguments& arguments) {
  SourceOptions options;
  if (!arguments.spacing.empty()) {
    glm::dvec3 spacing(0.0);
    char first = 0;
    char second = 0;
    std::istringstream text(arguments.spacing);
    text >> spacing.x >> first >> spacing.y >> second >> spacing.z;
    const bool complete = text && text.peek() == EOF && first == ',' && second == ',';
    if (!complete || !(spacing.x > 0) || !(spacing.y > 0) || !(spacing.z > 0))
      throw Error(Error::Kind::usage,
                  "--spacing takes three positive numbers of millimetres, such as 0.5,0.5,1.2.");
    options.read.spacingMm = spacing;
  }
  if (arguments.series > 0)
    options.read.series = arguments.series;
  if (arguments.memoryMb > 0.0)
    options.read.memory = MemoryBudget(static_cast<std::uint64_t>(1e6 * arguments.memoryMb));
  if (!arguments.volume.empty())
    options.volume = arguments.volume;
  options.read.part = arguments.part;
  return options;
}

LoadedScene loadScene(const SourceArguments& arguments, const Progress& progress, bool bringsView) {
  SourceOptions options = sourceOptions(arguments);
  options.bringsView = bringsView;
  LoadedScene loaded = loadScene(arguments.source, options, progress);
  if (!arguments.quiet)
    for (const Message& remark : loaded.notes)
      note(remark.english());
  return loaded;
}

Progress terminalProgress(bool quiet) {
  Progress progress;
  if (quiet || !isatty(STDERR_FILENO))
    return progress;
  progress.report = [shown = std::string()](double fraction, const Message& message) mutable {
    const std::string what = message.english();
    char line[160];
    if (fraction < 0.0)
      std::snprintf(line, sizeof line, "%s%s", clearedLine, what.c_str());
    else
      std::snprintf(line, sizeof line, "%s%s %3.0f %%%s", clearedLine, what.c_str(), 100.0 * fraction,
                    fraction >= 1.0 ? clearedLine : "");
    if (shown != line)
      std::fputs(line, stderr);
    shown = line;
  };
  return progress;
}

Progress patientProgress(bool quiet) {
  Progress progress = terminalProgress(quiet);
  if (quiet || progress.report)
    return progress;
  using Clock = std::chrono::steady_clock;
  progress.report = [told = std::make_shared<Clock::time_point>(Clock::now())](double fraction,
                                                                               const Message& message) {
    constexpr std::chrono::seconds pause(10);
    if (Clock::now() - *told < pause)
      return;
    *told = Clock::now();
    const int percent = static_cast<int>(100.0 * fraction);
    note(message.english() + (fraction < 0.0 ? "." : ": " + std::to_string(percent) + " %."));
  };
  return progress;
}

glm::ivec2 parsedSize(const std::string& text) {
  glm::ivec2 size(0);
  char times = 0;
  std::istringstream stream(text);
  stream >> size.x >> times >> size.y;
  if (!stream || stream.peek() != EOF || times != 'x' || size.x < 1 || size.y < 1 || size.x > 16384 ||
      size.y > 16384)
    throw Error(Error::Kind::usage,
                "--size takes WIDTHxHEIGHT in pixels from 1x1 to 16384x16384, such as 800x600.");
  return size;
}

void requireReportFolder(const fs::path& folder) {
  std::error_code unknown;
  fs::path there = fs::current_path() / folder; // which it is where nothing else is named
  while (!fs::exists(there, unknown) && there.has_relative_path())
    there = there.parent_path();
  // The dot refuses a file in a folder's place.
  if (::access((there / ".").c_str(), W_OK | X_OK) != 0)
    failFolder(folder, std::strerror(errno));
}

void makeReportFolder(const fs::path& folder) {
  if (const Message why = makeFolders(folder); !why.empty())
    failFolder(folder, why.english());
}

void note(const std::string& sentence) {
  std::fprintf(stderr, "%slimn: %s\n", isatty(STDERR_FILENO) ? clearedLine : "", sentence.c_str());
}

} // namespace limn
