// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"

#include "app/commands/SceneArguments.h"
#include "app/core/making/Jobs.h"
#include "app/core/making/Turntable.h"
#include "app/presets/PresetStore.h"

#include <cstdlib>
#include <iostream>
#include <memory>
#include <sstream>

namespace limn {
namespace {

namespace fs = std::filesystem;

const std::map<std::string, int> pictureFormats{{"png", 0}, {"tif", 0}, {"jpg", 0}, {"exr", 0}};

Sweep nothingGiven() {
  Sweep sweep;
  sweep.engine.clear();
  return sweep;
}

struct JobsArguments {
  Sweep given = nothingGiven(); ///< what of it is not given is empty
  std::string from;
};

/// The sweep of the file, with what was given in its place.
Sweep sweepOf(const JobsArguments& arguments) {
  Sweep sweep = arguments.from.empty() ? Sweep{} : readSweepFile(arguments.from);
  const auto replace = [](auto& value, const auto& given, const auto& nothing) {
    if (given != nothing)
      value = given;
  };
  const Sweep& given = arguments.given;
  const std::vector<std::string> noList;
  replace(sweep.volumes, given.volumes, noList);
  replace(sweep.presets, given.presets, noList);
  replace(sweep.models, given.models, noList);
  replace(sweep.views, given.views, noList);
  replace(sweep.turntable, given.turntable, 0);
  for (std::string Sweep::*text : {&Sweep::size, &Sweep::keep, &Sweep::engine, &Sweep::folder})
    replace(sweep.*text, given.*text, std::string());
  if (given.format != Sweep{}.format)
    sweep.format = given.format;
  replace(sweep.tolerance, given.tolerance, 0.0);
  replace(sweep.stepVoxels, given.stepVoxels, 0.0);
  replace(sweep.threads, given.threads, 0);
  return sweep;
}

/// What `limn render` would refuse of every picture alike is refused here, before anything is drawn.
Sweep checked(Sweep sweep) {
  if (sweep.folder.empty())
    throw Error(Error::Kind::usage, "Where shall the pictures go? Give a folder with -o.");
  if (!sweep.size.empty())
    parsedSize(sweep.size);
  for (const std::string& volume : sweep.volumes)
    if (const std::string source = absoluteSource(volume);
        fs::path(source).is_absolute() && !fs::exists(source))
      throw Error(Error::Kind::input,
                  "Cannot read " + source + ": there is no such file or folder; check its name.");
  const std::vector<Preset> presets = allPresets(PresetStore::ofThisUser());
  for (std::string& preset : sweep.presets)
    if (fs::is_regular_file(preset))
      preset = fs::absolute(preset).lexically_normal().string();
    else
      presetNamed(presets, preset);
  for (const std::string& model : sweep.models)
    if (model != "compare")
      modelNamed(model, "--model (beside compare)");
  for (const std::string& view : sweep.views)
    viewNamed(view);
  chosen(pictureFormats, sweep.format, "--format");
  return sweep;
}

/// How a shell calls this program from anywhere: by its name where the search path has it, otherwise by its
/// path.
std::string thisProgram() {
  const fs::path self = fs::read_symlink("/proc/self/exe");
  const char* paths = std::getenv("PATH");
  std::istringstream folders(paths ? paths : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::error_code unknown;
    if (const fs::path candidate = fs::path(folder) / "limn"; fs::exists(candidate, unknown))
      return fs::equivalent(candidate, self, unknown) ? "limn" : self.string();
  }
  return self.string();
}

void runJobs(const JobsArguments& arguments) {
  const Sweep sweep = checked(sweepOf(arguments));
  const std::vector<Job> jobs = jobsOf(sweep);
  makeReportFolder(sweep.folder);
  const std::string program = thisProgram();
  for (const Job& job : jobs)
    std::cout << shellLine(program, job.words) << '\n';
}

} // namespace

void addJobsCommand(CommandSyntax& root) {
  auto arguments = std::make_shared<JobsArguments>();
  Sweep& given = arguments->given;
  CommandSyntax command =
      root.command("jobs", "many pictures as commands, one a line, for xargs, GNU parallel or a cluster");
  command.option("VOLUMES", given.volumes, "volumes, DICOM folders, scene files").file();
  command.option("--preset", given.presets, "presets, separated by commas")
      .separatedByCommas()
      .words(presetWords)
      .file(lookEndings());
  command.option("--model", given.models, "shading models, separated by commas; compare is one, too")
      .separatedByCommas()
      .words(modelWordsAndCompare);
  command.option("--view", given.views, "standard views, separated by commas")
      .separatedByCommas()
      .words(viewWords);
  command.option("--turntable", given.turntable, "so many pictures of one turn about the patient")
      .within(2, mostFrames);
  command.option("--size", given.size, "WIDTHxHEIGHT in pixels (default: the scene's, 512x512)");
  command.option("--keep", given.keep, "all, or body").words(keepWords);
  command.option("--tolerance", given.tolerance, "as of limn render").within(0.01, 255.0);
  command.option("--step", given.stepVoxels, "as of limn render").within(1e-4, 1e4);
  command
      .option("--engine", given.engine,
              "as of limn render (default: cpu, whose pictures are the same everywhere)")
      .words(renderEngineWords);
  command
      .option("--threads", given.threads,
              "of each picture: 1 where several are drawn at once (default: every core)")
      .within(1, 4096);
  command.option("--format", given.format, "png, tif, jpg or exr (default: png)")
      .words(wordsOf(pictureFormats));
  command
      .option("--from", arguments->from, "a sweep file with all this in JSON; what is given here replaces it")
      .file({".json"});
  command.option("-o,--output", given.folder, "a folder for the pictures, which is made").folder();
  command.footer("Example: limn jobs *.nii.gz --preset \"CT bone,CT skin\" --threads 1 -o pictures | xargs "
                 "-d '\\n' -n 1 "
                 "-P 8 sh -c");
  command.runs([arguments] { runJobs(*arguments); });
}

} // namespace limn
