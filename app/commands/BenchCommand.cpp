// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"

#include "app/commands/NamedLook.h"
#include "app/commands/SceneArguments.h"
#include "app/document/PrivateNames.h"
#include "app/lab/bench/ScaleBench.h"
#include "app/presets/PresetStore.h"
#include "io/AtomicFile.h"
#include "io/reports/ReportJson.h"
#include "io/reports/ScalePage.h"
#include "scene/basics/Error.h"
#include "scene/presets/PresetFit.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <memory>

namespace limn {
namespace {

// The pictures whose median time stands for a point of a curve of error over time.
constexpr int framesOfACurve = 5;

struct BenchArguments {
  SourceArguments source; ///< its `source` is unused: there may be several
  std::vector<std::string> sources;
  std::vector<std::string> presets;
  std::vector<double> steps;
  std::vector<std::string> models;
  std::vector<std::string> engines; ///< empty: not given
  BenchEntries entries;
  bool rivals = false;
  std::string size;
  std::string pictures;
  int frames = 9;
  bool equalError = false;
  bool scale = false;
  int largest = 1024; ///< voxels along each axis of the largest volume of --scale
  std::string page;   ///< where --scale writes it; empty: nowhere
  bool json = false;
};

// One scene to measure.
struct BenchScene {
  std::string name;
  Scene scene;
  std::string volumePath;
};

// As they look on a volume.
std::vector<Preset> presetsFor(const std::vector<std::string>& names, const Volume& volume, bool isQuiet) {
  const bool isAll = names == std::vector<std::string>{"all"};
  const std::vector<Preset> known = isAll ? builtInPresets() : allPresets(PresetStore::ofThisUser());
  const auto fitted = [&](const Preset& preset) {
    return fittedTo(preset, histogramOf(volume), volume.grid());
  };
  std::vector<Preset> presets;
  if (isAll)
    for (const Preset& preset : known)
      presets.push_back(fitted(preset));
  else
    for (const std::string& name : names)
      presets.push_back(namesLookFile(name) ? presetAskedFor(name, volume, isQuiet)
                                            : fitted(presetNamed(known, name)));
  return presets;
}

std::vector<BenchScene> scenesOf(const std::string& name, const BenchArguments& arguments,
                                 const Progress& progress) {
  SourceArguments source = arguments.source;
  source.source = name;
  const LoadedScene loaded = loadScene(source, progress);
  const QString file = shareableName(QString::fromStdString(name), *loaded.scene.volume);
  const std::string stem = std::filesystem::path(file.toStdString()).stem().string();
  std::vector<BenchScene> scenes;
  for (const Preset& preset : presetsFor(arguments.presets, *loaded.scene.volume, arguments.source.quiet))
    scenes.push_back({stem + ", " + preset.name, withPreset(loaded.scene, preset), loaded.volumePath});
  if (scenes.empty())
    scenes.push_back(
        {loaded.preset.empty() ? stem : stem + ", " + loaded.preset, loaded.scene, loaded.volumePath});
  if (!arguments.size.empty())
    for (BenchScene& scene : scenes) {
      const glm::ivec2 size = parsedSize(arguments.size);
      scene.scene.image.width = size.x;
      scene.scene.image.height = size.y;
    }
  return scenes;
}

// The scenes with every model asked for, by default their own.
std::vector<BenchScene> withModels(const std::vector<BenchScene>& scenes,
                                   const std::vector<std::string>& models) {
  if (models.empty())
    return scenes;
  std::vector<BenchScene> all;
  for (const BenchScene& scene : scenes)
    for (const std::string& model : models) {
      all.push_back(scene);
      all.back().name += ", " + model;
      all.back().scene.shading.model = modelNamed(model, "--model");
    }
  return all;
}

// The scenes at every step asked for, by default their own.
std::vector<BenchScene> withSteps(const std::vector<BenchScene>& scenes, const std::vector<double>& steps) {
  if (steps.empty())
    return scenes;
  std::vector<BenchScene> all;
  for (const BenchScene& scene : scenes)
    for (const double step : steps) {
      all.push_back(scene);
      all.back().scene.quality.stepVoxels = step;
    }
  return all;
}

std::vector<BenchScene> allScenes(const BenchArguments& arguments, const Progress& progress) {
  std::vector<BenchScene> all;
  for (const std::string& source : arguments.sources)
    for (const BenchScene& scene :
         withSteps(withModels(scenesOf(source, arguments, progress), arguments.models), arguments.steps))
      all.push_back(scene);
  return all;
}

BenchEntries entriesFor(const BenchArguments& arguments) {
  BenchEntries entries = arguments.entries;
  if (!arguments.engines.empty())
    entries.engines = arguments.engines;
  else if (arguments.scale)
    entries.engines = {"gl", "cpu"};
  if (arguments.rivals)
    for (const char* rival : {"vtk-gpu", "vtk-fixedpoint"})
      if (std::ranges::find(entries.engines, rival) == entries.engines.end())
        entries.engines.push_back(rival);
  if (!arguments.source.spacing.empty())
    entries.readOptions = {"--spacing", arguments.source.spacing};
  if (arguments.source.series > 0)
    for (const std::string& word : {std::string("--series"), std::to_string(arguments.source.series)})
      entries.readOptions.push_back(word);
  return entries;
}

void savePictures(const std::vector<std::unique_ptr<Contender>>& contenders, const BenchScene& scene,
                  const std::string& folder) {
  std::filesystem::create_directories(folder);
  char step[32];
  std::snprintf(step, sizeof step, "%g", scene.scene.quality.stepVoxels);
  for (const auto& contender : contenders) {
    contender->draw(scene.scene);
    contender->save(std::filesystem::path(folder) /
                    (scene.name + ", step " + step + ", " + contender->program() + ".png"));
  }
}

// What was measured, as it is printed.
struct BenchResult {
  std::string driver; ///< of the first renderer
  std::vector<BenchRow> rows;
  std::vector<EqualErrorRow> equalErrors;
};

// Adds the rows of one scene. `advance` is called after every picture.
void measureScene(const BenchScene& scene, const BenchArguments& arguments, const BenchEntries& entries,
                  const std::function<void(int drawn, int of)>& advance, BenchResult& result) {
  auto contenders = contendersFor(entries, scene.volumePath);
  int drawn = 0;
  const int eachDraws = picturesPerRow(arguments.frames) + (arguments.equalError ? 1 : 0);
  const int pictures = eachDraws * static_cast<int>(contenders.size());
  const auto next = [&] { advance(++drawn, pictures); };
  auto rows = benchRows(scene.name, scene.scene, contenders, arguments.frames, next);
  std::vector<BenchRow*> measured;
  for (BenchRow& row : rows)
    if (row.missing.empty())
      measured.push_back(&row);
  std::erase_if(contenders, [&](const auto& contender) {
    return std::ranges::none_of(measured,
                                [&](const BenchRow* row) { return row->program == contender->program(); });
  });
  if (result.driver.empty())
    result.driver = contenders.front()->renderer();
  // Only now: an exact picture drawn before would warm the process up for the first ones.
  const PictureErrors errors(scene.scene, contenders, entries.threads);
  for (std::size_t k = 0; k < contenders.size(); ++k)
    measured[k]->meanError = errors.meanError(*contenders[k], scene.scene);
  result.rows.insert(result.rows.end(), rows.begin(), rows.end());
  if (arguments.equalError) {
    const auto compared = equalErrorRows(scene.name, scene.scene, contenders, errors,
                                         std::min(arguments.frames, framesOfACurve), next);
    result.equalErrors.insert(result.equalErrors.end(), compared.begin(), compared.end());
  }
  if (!arguments.pictures.empty())
    savePictures(contenders, scene, arguments.pictures);
}

// Volumes of several sizes, each drawn by every renderer before the next is opened.
ScaleFigures measureSizes(const BenchArguments& arguments, const BenchEntries& entries,
                          const std::vector<int>& edges, const Progress& progress) {
  ScaleFigures all;
  for (std::size_t size = 0; size < edges.size(); ++size) {
    int done = 0;
    const auto advance = [&] {
      const double share = std::min(1.0, static_cast<double>(++done) / scaleSteps(entries, arguments.frames));
      if (progress.report)
        progress.report((static_cast<double>(size) + share) / static_cast<double>(edges.size()),
                        "Measuring " + std::to_string(edges[size]) + " voxels along each axis");
    };
    const ScaleFigures more = scaleFigures(edges[size], entries, arguments.frames, advance);
    all.rows.insert(all.rows.end(), more.rows.begin(), more.rows.end());
    all.bricks.insert(all.bricks.end(), more.bricks.begin(), more.bricks.end());
  }
  return all;
}

void runScale(const BenchArguments& arguments) {
  if (!arguments.sources.empty())
    throw Error(Error::Kind::usage, "limn bench --scale makes its own volumes; leave " +
                                        arguments.sources.front() + " out, or --scale.");
  const BenchEntries entries = entriesFor(arguments);
  const std::vector<int> edges = scaleEdges(arguments.largest);
  const ScaleFigures figures =
      measureSizes(arguments, entries, edges, terminalProgress(arguments.source.quiet));
  std::string machine = machineName();
  for (const std::string& engine : entries.engines)
    for (const ScaleRow& row : figures.rows)
      if (row.edge == edges.front() && row.drawn.missing.empty() && row.drawn.program.ends_with(engine))
        machine += ", " + row.drawn.renderer;
  if (!arguments.page.empty())
    writeFileAtomically(arguments.page,
                        scalePage("limn bench --scale --frames " + std::to_string(arguments.frames) +
                                      " --largest " + std::to_string(arguments.largest),
                                  machine, figures.rows, figures.bricks));
  std::cout << (arguments.json ? scaleJson(machine, figures.rows, figures.bricks)
                               : scaleTable(machine, figures.rows) + brickTable(figures.bricks));
}

void runBench(const BenchArguments& arguments) {
  // A shader that an earlier run left on disk would make the first frame look fast.
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  if (!arguments.page.empty())
    requireWritable(arguments.page);
  if (!arguments.pictures.empty())
    requireReportFolder(arguments.pictures);
  if (arguments.scale)
    return runScale(arguments);
  if (arguments.sources.empty())
    throw Error(Error::Kind::usage, "limn bench needs a volume or scene, such as: limn bench head.nii.gz");
  const Progress progress = terminalProgress(arguments.source.quiet);
  const std::vector<BenchScene> scenes = allScenes(arguments, progress);
  const BenchEntries entries = entriesFor(arguments);
  BenchResult result;
  for (std::size_t i = 0; i < scenes.size(); ++i)
    measureScene(
        scenes[i], arguments, entries,
        [&](int drawn, int of) {
          if (progress.report)
            progress.report((static_cast<double>(i) + static_cast<double>(drawn) / of) /
                                static_cast<double>(scenes.size()),
                            "Measuring " + scenes[i].name);
        },
        result);
  for (const BenchScene& scene : scenes)
    requireWhole(scene.volumePath, *scene.scene.volume);
  const std::string machine = machineName() + ", " + result.driver;
  if (arguments.json)
    std::cout << benchJson(machine, result.rows, result.equalErrors);
  else
    std::cout << benchTable(machine, result.rows)
              << (result.equalErrors.empty() ? "" : equalErrorTable(result.equalErrors));
}

} // namespace

void addBenchCommand(CommandSyntax& root) {
  auto arguments = std::make_shared<BenchArguments>();
  CommandSyntax command = root.command("bench", "milliseconds per frame by renderer, scene and step");
  command.option("SOURCE", arguments->sources, "scene files, volumes, `sample` or `phantom:SPACING`")
      .words({"sample"})
      .file();
  addSourceOptions(command, arguments->source);
  command.flag("--quiet", arguments->source.quiet, "no progress and no remarks on stderr");
  command.flag("--json", arguments->json, "one JSON object on stdout");
  command.option("--size", arguments->size, "WIDTHxHEIGHT in pixels (default: the scene's, 512x512)");
  command.option("--step", arguments->steps, "sampling steps in voxels, such as 1,0.5")
      .separatedByCommas()
      .within(1e-4, 1e4);
  command.option("--frames", arguments->frames, "views of one turn of the camera (default 9)")
      .within(1, 10000);
  command.option("--model", arguments->models, "shading models, such as classic,enhanced")
      .separatedByCommas()
      .words(modelWords);
  command
      .option(
          "--preset", arguments->presets,
          "name of a preset or a file with a look, several times if wanted, or all: every built-in preset")
      .words(presetWords)
      .file(lookEndings());
  command
      .option("--engine", arguments->engines,
              "gl (default), cpu, slices, reference, vtk-gpu, vtk-fixedpoint, or several: gl,cpu; cpu where "
              "there is no OpenGL")
      .separatedByCommas()
      .oneOf({"gl", "cpu", "slices", "reference", "vtk-gpu", "vtk-fixedpoint"});
  command
      .option("--threads", arguments->entries.threads,
              "threads of the CPU engine and the reference (default: every core)")
      .within(1, 4096);
  command.flag("--all-effects", arguments->entries.allEffects,
               "the program with every effect compiled in draws the same views in turn");
  command.flag(
      "--rivals", arguments->rivals,
      "VTK's GPU mapper and fixed-point caster (vtk-gpu, vtk-fixedpoint) draw the same views in turn; "
      "they need an X display");
  command.flag("--equal-error", arguments->equalError,
               "also how fast each is where it errs as VTK's GPU mapper does, or else the first of them");
  command.flag(
      "--scale", arguments->scale,
      "how opening, first picture, frame and memory grow from 128 to 1024 voxels along each axis, and how "
      "bricks share the work of 1 to 8 ranks, with gl and cpu unless --engine says otherwise; makes its "
      "volumes, of 8 bits, in the folder for "
      "temporary files");
  command
      .option("--largest", arguments->largest, "voxels along each axis at most with --scale (default 1024)")
      .within(128, 2048);
  command
      .option("--page", arguments->page,
              "with --scale: a page (HTML) of the figures, and what follows for 10^12 voxels on 1000 nodes")
      .file({".html"});
  command.option("--pictures", arguments->pictures, "folder to save each renderer's picture in").folder();
  command.footer("Each view of one turn is drawn by every renderer before the next view; a frame ends when "
                 "its pixels are there.\nExample: limn bench head.nii.gz --preset \"CT bone\" --step 1,0.5");
  command.runs([arguments] { runBench(*arguments); });
}

} // namespace limn
