// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"

#include "accuracy/sweep/FigureText.h"
#include "app/commands/NamedLook.h"
#include "app/commands/SceneArguments.h"
#include "app/core/drawing/OnDisk.h"
#include "app/core/drawing/PathAccuracy.h"
#include "app/core/drawing/PictureMaker.h"
#include "app/core/drawing/RealRenderers.h"
#include "app/document/PrivateNames.h"
#include "app/document/Settings.h"
#include "app/lab/accuracy/AccuracyTable.h"
#include "app/lab/accuracy/ExactBy.h"
#include "app/lab/accuracy/MeasureDecisions.h"
#include "app/lab/accuracy/RivalPoints.h"
#include "app/language/Language.h"
#include "io/AtomicFile.h"
#include "io/reports/AccuracyFile.h"
#include "io/reports/AccuracyPage.h"
#include "io/reports/ReportJson.h"
#include "io/scenefile/SceneFile.h"
#include "scene/effects/EffectPlan.h"
#include "widgets/accuracy/ChartPicture.h"

#include <QApplication>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <sstream>

namespace limn {
namespace {

struct AccuracyArguments {
  SceneArguments scene;
  std::vector<std::string> reports; ///< to be joined instead of measuring
  std::string folder;
  std::string engine = "auto";
  std::string exactBy; ///< a program that draws the converged picture; empty: the reference
  int threads = 0;
  bool isQuick = false;
  bool hasRivals = false;
  double withinLevels = 0.0; ///< 0: not given
  double withinMs = 0.0;     ///< 0: not given
};

namespace fs = std::filesystem;

constexpr QSize chartSize(1600, 1000);
constexpr const char* reportName = "accuracy.json";

std::string nameOf(const SceneArguments& arguments, const LoadedScene& loaded) {
  // The report may travel.
  const QString file = shareableName(QString::fromStdString(arguments.source.source), *loaded.scene.volume);
  std::string name = std::filesystem::path(file.toStdString()).stem().stem().string();
  const std::string preset = arguments.preset.empty() ? loaded.preset : calledName(arguments.preset);
  if (!preset.empty())
    name += ", " + preset;
  return name;
}

// Charts are drawn by widgets, which need an application but no display.
void writeChart(const AccuracyReport& report, const std::filesystem::path& path) {
  setenv("QT_QPA_PLATFORM", "offscreen", 1);
  char name[] = "limn";
  char* words[] = {name, nullptr};
  int count = 1;
  const QApplication application(count, words);
  keepNumbersOfFiles();
  const QImage chart = accuracyChartPicture(report, chartSize);
  replaceAtomically(path, [&](const std::filesystem::path& temporary) {
    if (!chart.save(QString::fromStdString(temporary.string()), "PNG"))
      throw Error(Error::Kind::other,
                  "The chart " + path.string() + " cannot be written; is there room on the disk?");
  });
}

void writeReport(const AccuracyReport& report, const std::filesystem::path& folder) {
  makeReportFolder(folder);
  writeFileAtomically(folder / reportName, accuracyJson(report));
  writeFileAtomically(folder / "accuracy.csv", accuracyCsv(report));
  writeFileAtomically(folder / "accuracy.html", accuracyPage(report, "accuracy.png"));
  writeChart(report, folder / "accuracy.png");
}

// How a program is to read the volume that this one has read.
std::string readOptionsOf(const ReadOptions& read) {
  char words[160] = "";
  if (read.spacingMm)
    std::snprintf(words, sizeof words, " --spacing %.17g,%.17g,%.17g", read.spacingMm->x, read.spacingMm->y,
                  read.spacingMm->z);
  return words + (read.series ? " --series " + std::to_string(*read.series) : std::string());
}

std::vector<std::string> rivalReadOptions(const ReadOptions& read) {
  std::vector<std::string> words;
  std::istringstream text(readOptionsOf(read));
  for (std::string word; text >> word;)
    words.push_back(word);
  return words;
}

ConvergedPicture exactPicture(const LoadedScene& loaded, const Scene& scene, RealRenderers& renderers,
                              const AccuracyArguments& arguments, const Progress& progress) {
  const glm::ivec2 size(scene.image.width, scene.image.height);
  if (arguments.exactBy.empty())
    return convergedPicture(scene, size, renderers.precisely(), progress.report);
  makeReportFolder(arguments.folder);
  const DrawingCommand command{arguments.exactBy, loaded.volumePath, readOptionsOf(loaded.read),
                               arguments.folder};
  ConvergedPicture picture = convergedPicture(scene, size, exactBy(command), progress.report);
  picture.facts.isInFloats = true;
  return picture;
}

// Who casts the rays: as `limn render` would, where nobody chose.
Engine raysOf(const AccuracyArguments& arguments, const Scene& scene) {
  if (arguments.engine == "auto")
    return staysOnDisk(scene) ? Engine::cpu : engineFor(scene, Settings().engineMemory());
  return arguments.engine == "cpu" ? Engine::cpu : Engine::rayCaster;
}

// They light both sides of a surface, which is another picture where the scene does not.
void measureRivals(AccuracyReport& report, const LoadedScene& loaded, const Scene& scene,
                   RealRenderers& renderers, const Progress& progress) {
  constexpr int frames = 3;
  Scene both = scene;
  both.shading.twoSided = true;
  const ConvergedPicture exact =
      convergedPicture(both, report.size, renderers.precisely(), part(progress, 0.0, 0.4).report);
  addRivals(report, scene, {loaded.volumePath, rivalReadOptions(loaded.read)}, exact.pixels, frames,
            part(progress, 0.4, 1.0).report);
}

// Steps or a tolerance that somebody asks for are measured beside the others.
std::vector<OperatingPoint> pointsOf(const AccuracyArguments& arguments) {
  std::vector<OperatingPoint> points = arguments.isQuick ? fewPoints() : usualPoints();
  OperatingPoint asked;
  if (arguments.scene.toleranceLevels > 0.0)
    asked.toleranceLevels = arguments.scene.toleranceLevels;
  else if (arguments.scene.stepVoxels > 0.0)
    asked.stepVoxels = arguments.scene.stepVoxels;
  else
    return points;
  return withPoint(std::move(points), asked);
}

// Of physical light paths are followed, by the processor, and nothing else is compared.
AccuracyReport pathReport(const LoadedScene& loaded, const Scene& scene, const AccuracyArguments& arguments,
                          const Progress& progress) {
  if (arguments.engine == "gl" || arguments.hasRivals || !arguments.exactBy.empty())
    throw Error(Error::Kind::usage,
                "Physical light is followed by the processor alone and tells its own error: "
                "leave out --engine gl, --rivals and --exact-by.");
  if (arguments.scene.toleranceLevels > 0.0)
    throw Error(Error::Kind::usage,
                "Physical light is measured by the number of its paths, not by steps that "
                "keep a tolerance: leave out --tolerance.");
  constexpr int mostPathsMeasured = 256, mostPathsQuick = 32;
  return measurePaths(nameOf(arguments.scene, loaded), scene, {scene.image.width, scene.image.height},
                      arguments.isQuick ? mostPathsQuick : mostPathsMeasured, {arguments.threads, {}, {}},
                      progress.report);
}

// Error and time of a scene: the converged picture, then every point, then each decision where wanted.
AccuracyReport measuredReport(const LoadedScene& loaded, const Scene& scene,
                              const AccuracyArguments& arguments, const Progress& progress) {
  const Engine rays = raysOf(arguments, scene);
  RealRenderers renderers(arguments.threads, {}, rays);
  const glm::ivec2 size(scene.image.width, scene.image.height);
  const double whole = arguments.hasRivals ? 0.8 : 1.0;
  const double end = arguments.isQuick ? whole : 0.7;
  const ConvergedPicture converged =
      exactPicture(loaded, scene, renderers, arguments, part(progress, 0.0, 0.3));
  const std::string name = nameOf(arguments.scene, loaded);
  AccuracyReport report = measureAccuracy(name, scene, size, pointsOf(arguments), converged, renderers,
                                          part(progress, 0.3, end).report);
  // Decisions are those of the textures.
  if (!arguments.isQuick && rays == Engine::rayCaster)
    report.decisions = measureDecisions(scene, size, converged.pixels, part(progress, end, whole).report);
  if (arguments.hasRivals)
    measureRivals(report, loaded, scene, renderers, part(progress, whole, 1.0));
  return report;
}

[[noreturn]] void failReport(const std::string& what) {
  throw Error(Error::Kind::input,
              what + "; give folders that limn accuracy -o wrote, or their accuracy.json.");
}

bool holdsReport(const fs::path& folder) {
  std::error_code unknown;
  return fs::is_regular_file(folder / reportName, unknown);
}

// The report that is meant by its file, or by the folder that `limn accuracy -o` made.
fs::path reportFile(const fs::path& named) {
  std::error_code unknown;
  if (!fs::exists(named, unknown))
    failReport("There is no report " + named.string());
  if (!fs::is_directory(named, unknown)) {
    if (const std::string ending = named.extension().string();
        ending == ".csv" || ending == ".html" || ending == ".png")
      failReport("The file " + named.string() + " shows a report to people; --join does not read it");
    return named;
  }
  if (holdsReport(named))
    return named / reportName;
  const bool isAbove = std::ranges::any_of(fs::directory_iterator(named, unknown),
                                           [](const auto& entry) { return holdsReport(entry.path()); });
  if (isAbove)
    throw Error(Error::Kind::input, "The folder " + named.string() +
                                        " holds reports in folders of their own; join them with --join " +
                                        (named / "*").string() + ".");
  failReport("The folder " + named.string() + " holds no report");
}

NamedReport readReport(const std::string& name) {
  const fs::path file = reportFile(name);
  return {name, parseAccuracy(readTextFile(file), file.string())};
}

void joinReports(const AccuracyArguments& arguments) {
  std::vector<NamedReport> reports;
  for (const std::string& name : arguments.reports)
    reports.push_back(readReport(name));
  makeReportFolder(arguments.folder);
  writeFileAtomically(std::filesystem::path(arguments.folder) / "cohort.csv", cohortCsv(reports));
  std::cout << cohortTable(cohortOf(reports));
}

void runAccuracy(const AccuracyArguments& arguments) {
  if (arguments.reports.empty() == arguments.scene.source.source.empty())
    throw Error(Error::Kind::usage, "limn accuracy measures a SOURCE, or joins reports with --join; give one "
                                    "of the two.");
  requireReportFolder(arguments.folder);
  if (!arguments.reports.empty())
    return joinReports(arguments);
  const Progress progress = patientProgress(arguments.scene.source.quiet);
  const LoadedScene loaded = loadScene(arguments.scene, progress);
  Scene scene = adjusted(loaded, arguments.scene);
  if (!arguments.scene.model.empty())
    scene.shading.model = modelNamed(arguments.scene.model, "--model");
  const AccuracyReport report = isPhysical(scene) ? pathReport(loaded, scene, arguments, progress)
                                                  : measuredReport(loaded, scene, arguments, progress);
  requireWhole(loaded.volumePath, *scene.volume);
  writeReport(report, arguments.folder);
  std::cout << accuracyTable(report);
  if (arguments.withinLevels > 0.0)
    std::cout << wishWithinLevels(report.points, arguments.withinLevels) << "\n";
  if (arguments.withinMs > 0.0)
    std::cout << wishWithinMs(report.points, arguments.withinMs) << "\n";
}

} // namespace

void addAccuracyCommand(CommandSyntax& root) {
  auto arguments = std::make_shared<AccuracyArguments>();
  CommandSyntax command = root.command("accuracy", "error against time of a scene");
  addSceneArguments(command, arguments->scene, "none, classic, enhanced, robust or physical");
  command.added("SOURCE").required(false);
  command.option("-o,--output", arguments->folder, "folder for accuracy.json, .csv, .png and .html")
      .required()
      .folder();
  command
      .option("--join", arguments->reports,
              "instead of measuring: reports (accuracy.json, or their folders) as one table, cohort.csv")
      .file({".json"});
  command
      .option(
          "--engine", arguments->engine,
          "who casts the rays: auto (the one that limn render would take), gl, or cpu; without gl neither "
          "slices nor decisions about textures are measured")
      .words([] {
        return std::vector<std::string>{"auto", "gl", "cpu"};
      });
  command.option("--exact-by", arguments->exactBy,
                 "a program that draws the exact picture in the reference's place, in single precision: one "
                 "that takes what limn render takes, such as \"mpirun -n 4 limn-mpi\"");
  command.option("--threads", arguments->threads, "threads of the reference (default: every core)")
      .within(1, 4096);
  command.flag(
      "--rivals", arguments->hasRivals,
      "VTK's GPU mapper and fixed-point caster as points of the same table and chart; they need an X "
      "display");
  command.flag("--quick", arguments->isQuick,
               "equal steps of the ray caster only, without what each decision costs");
  command
      .option("--within", arguments->withinLevels,
              "say which point is the fastest within that many levels (99.9th percentile)")
      .within(0.01, 255.0);
  command.option("--at-most-ms", arguments->withinMs, "say which point is the most accurate in that time")
      .within(0.01, 1e7);
  command.footer("Errors are told in levels of 255 against a picture in double precision that finer steps no "
                 "longer change; of physical light by its own standard error, after 4 to 256 paths a pixel. "
                 "What --step or --tolerance "
                 "ask for is measured beside the usual points.\n"
                 "Example: limn accuracy head.nii.gz --preset \"CT bone\" --within 1 -o report\n"
                 "Example: limn accuracy --join reports/* -o cohort");
  command.runs([arguments] { runAccuracy(*arguments); });
}

} // namespace limn
