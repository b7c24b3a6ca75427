// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"

#include "app/commands/Arguments.h"
#include "app/core/drawing/ComparedSides.h"
#include "app/core/drawing/ProcessCost.h"
#include "app/core/sources/BuiltInPresets.h"
#include "app/core/sources/NamedFiles.h"
#include "app/document/Settings.h"
#include "cpu/CpuRenderer.h"
#include "gl/DriverHealth.h"
#include "gl/HeadlessContext.h"
#include "glsl/programs/FilterBits.h"
#include "io/ImageFile.h"
#include "io/reports/ReportJson.h"
#include "raycaster/RayCaster.h"
#include "scene/basics/Error.h"
#include "scene/light/LightPresets.h"
#include "scene/light/ModulusSearch.h"
#include "scene/volume/Phantom.h"

#include <QString>
#include <QSysInfo>
#include <QtGlobal>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

namespace limn {
namespace {

struct InfoArguments {
  SourceArguments source;
  bool json = false;
  bool system = false;
};

// "stored - 1024", "0.5 * stored + 3".
std::string rescaleText(const Rescale& rescale) {
  char factor[40] = "";
  char offset[40] = "";
  if (rescale.slope != 1.0)
    std::snprintf(factor, sizeof factor, "%.6g * ", rescale.slope);
  if (rescale.intercept != 0.0)
    std::snprintf(offset, sizeof offset, " %c %.6g", rescale.intercept < 0.0 ? '-' : '+',
                  std::abs(rescale.intercept));
  return std::string(factor) + "stored" + offset;
}

// As its list calls it.
std::string curveName(const Scene& scene, bool isTold) {
  for (const Preset& preset : builtInPresets())
    if (preset.transferFunction == scene.transferFunction)
      return "preset \"" + preset.name + "\"";
  return isTold ? "of its own" : "left to the program";
}

// "from anterior and left": the directions to which the view leans by a sixteenth of a turn at least.
std::string viewName(const SceneDocument& document) {
  constexpr double leastShare = 0.38; // sin 22.5°
  const glm::dvec3 from = -basisOf(document.scene.camera).forward;
  std::string name = document.hasCamera ? "from" : "left to the program";
  for (const auto& [share, side] :
       {std::pair(-from.y, "anterior"), std::pair(from.y, "posterior"), std::pair(from.x, "left"),
        std::pair(-from.x, "right"), std::pair(from.z, "superior"), std::pair(-from.z, "inferior")})
    if (document.hasCamera && share > leastShare)
      name += (name == "from" ? " " : " and ") + std::string(side);
  return name;
}

std::string counted(std::ptrdiff_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

// What of the volume a scene does not show, as far as that is told without it.
std::vector<std::string> hiddenIn(const SceneDocument& document) {
  const KeptPart& keep = document.keep;
  std::vector<std::string> hidden;
  if (keep.kind == Region::Kind::body || keep.hidesTable)
    hidden.emplace_back("the table (body only)");
  const auto weighed =
      std::ranges::count_if(keep.weights, [](const auto& weight) { return weight.second != 1.0; });
  if (weighed > 0)
    hidden.push_back(counted(weighed, "label") + " (hidden or faded)");
  const auto cuts = std::ranges::count_if(keep.cuts, takesAway);
  if (cuts > 0)
    hidden.push_back("what " + counted(cuts, "cut") + (cuts == 1 ? " takes" : " take") + " away");
  if (document.scene.crop != CropBox())
    hidden.emplace_back("what lies outside the crop");
  return hidden;
}

// Of each picture that it makes, from left to right.
void addScene(CarriedFacts& facts, const SceneDocument& document) {
  const auto add = [](std::vector<std::string>& names, const std::string& name) {
    if (std::ranges::find(names, name) == names.end())
      names.push_back(name);
  };
  for (const Scene& scene : scenesShown(document.scene, document.sides.value_or(ShownSides{}))) {
    const std::optional<LightPreset> light = lightPresetOf(scene.shading);
    add(facts.curves, curveName(scene, document.hasTransferFunction));
    add(facts.models, nameOf(scene.shading.model));
    add(facts.lights, light ? nameOf(*light) : "of its own");
  }
  add(facts.views, viewName(document));
  for (const std::string& hidden : hiddenIn(document))
    add(facts.hidden, hidden);
  add(facts.volumes, document.volume);
}

// Of a figure each picture's own, but for slices, under its letter where there are several.
void addAccuracy(CarriedFacts& facts, const FigureDocument& figure) {
  const auto isStated = [](const FigurePanelDocument& panel) { return panel.accuracy.has_value(); };
  if (std::ranges::none_of(figure.panels, isStated))
    return;
  bool areKnown = true;
  double worst = 0.0;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const FigurePanelDocument& panel = figure.panels[i];
    if (panel.plane)
      continue;
    facts.statement += facts.statement.empty() ? "" : " ";
    if (figure.panels.size() > 1)
      facts.statement += std::string(1, static_cast<char>('a' + i)) + ": ";
    facts.statement += panel.accuracy ? panel.accuracy->sentence : "Not stated.";
    areKnown = areKnown && panel.accuracy && panel.accuracy->levels;
    worst = areKnown ? std::max(worst, *panel.accuracy->levels) : worst;
  }
  if (areKnown)
    facts.withinLevels = worst;
}

// What a picture says of itself, which needs no volume; nothing of any other source.
std::optional<CarriedFacts> carriedFacts(const std::string& source) {
  const std::string text = carriedBy(source);
  if (text.empty())
    return std::nullopt;
  const std::string name = std::filesystem::path(source).filename().string();
  CarriedFacts facts;
  facts.size = readImageSize(source);
  if (looksLikeFigure(text)) {
    const FigureDocument figure = parseFigure(text, name);
    for (const FigurePanelDocument& panel : figure.panels)
      addScene(facts, panel.scene);
    addAccuracy(facts, figure);
    return facts;
  }
  addScene(facts, parseScene(text, name));
  if (const std::optional<PictureAccuracy> accuracy = accuracyIn(text, name)) {
    facts.withinLevels = accuracy->levels;
    facts.statement = accuracy->sentence;
  }
  return facts;
}

void printText(const CarriedFacts& facts) {
  const auto line = [](const char* what, const std::vector<std::string>& told) {
    std::printf("%-12s", what);
    for (std::size_t n = 0; n < told.size(); ++n)
      std::printf("%s%s", n > 0 ? ", " : "", told[n].c_str());
    std::printf("\n");
  };
  if (facts.size)
    std::printf("picture     %d x %d pixels\n", facts.size->x, facts.size->y);
  line("curve", facts.curves);
  line("model", facts.models);
  line("light", facts.lights);
  line("view", facts.views);
  if (!facts.hidden.empty())
    line("hidden", facts.hidden);
  line("accuracy", {facts.statement.empty() ? "not stated" : facts.statement});
  std::vector<std::string> volumes = facts.volumes;
  for (std::string& volume : volumes)
    if (const auto head = installedSampleHead(); head && head->filename() == volume)
      volume += " (the sample head)";
  line("volume", volumes);
}

void printText(const VolumeFacts& facts) {
  const Volume& volume = *facts.volume;
  const Grid& grid = volume.grid();
  const std::string unit = volume.info().unit.empty() ? "" : " " + volume.info().unit;
  const std::string perMm = (volume.info().unit.empty() ? "value" : volume.info().unit) + "/mm";
  std::printf("format      %s%s%s\n", volume.info().format.c_str(),
              volume.info().modality.empty() ? "" : ", ", volume.info().modality.c_str());
  std::printf("dimensions  %d x %d x %d voxels\n", grid.dims.x, grid.dims.y, grid.dims.z);
  std::printf("spacing     %.4g x %.4g x %.4g mm%s\n", grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z,
              volume.info().spacingKnown ? "" : " (assumed)");
  std::printf("origin      %.6g, %.6g, %.6g mm (LPS)\n", grid.originMm.x, grid.originMm.y, grid.originMm.z);
  for (int row = 0; row < 3; ++row)
    std::printf("%s% .6f % .6f % .6f\n", row == 0 ? "direction   " : "            ", grid.direction[0][row],
                grid.direction[1][row], grid.direction[2][row]);
  if (!volume.info().orientationKnown)
    std::printf("            orientation unknown\n");
  std::printf("type        %s, value = %s\n", voxelTypeName(volume.stored()).c_str(),
              rescaleText(volume.rescale()).c_str());
  std::printf("range       %.6g to %.6g%s\n", volume.range().lowest, volume.range().highest, unit.c_str());
  std::printf("invalid     %zu %s\n", volume.invalidVoxels(),
              volume.invalidVoxels() == 1 ? "voxel" : "voxels");
  std::printf("gradient    largest %.6g, 99.5th percentile %.6g %s\n", facts.gradientMax,
              facts.gradientPercentile, perMm.c_str());
  for (const SeriesSummary& series : facts.series)
    std::printf("series %-4d %s %d x %d x %d %s\n", series.number, series.modality.c_str(), series.dims.x,
                series.dims.y, series.dims.z, series.description.c_str());
  for (const Message& warning : volume.info().warnings)
    std::printf("warning     %s\n", warning.english().c_str());
}

void printDriver(const DriverFacts& driver) {
  std::printf("OpenGL      %s\n", driver.renderer.c_str());
  std::printf("version     %s, GLSL %s\n", driver.version.c_str(), driver.shadingLanguage.c_str());
  std::printf("3D textures up to %d texels along an edge\n", driver.largest3dTexture);
  std::printf("resets      %s\n", driver.tellsOfResets ? "are told" : "are not told by this driver");
}

// Draws a small head in every model, so that a report holds what the driver says of the shaders.
void printTrial() {
  Scene scene;
  scene.volume = phantomVolume({.spacingMm = 16.0});
  scene.camera = defaultCamera(scene.volume->grid());
  scene.transferFunction.points = {{-300.0, glm::dvec3(0.9, 0.6, 0.5), 0.0},
                                   {300.0, glm::dvec3(1.0, 0.9, 0.8), 0.5}};
  try {
    RayCaster caster;
    for (const ShadingModel model : localModels) {
      scene.shading.model = model;
      caster.render(scene, {16, 16});
    }
    std::printf("drawing     works in all four models\n");
  } catch (const DriverError& error) {
    std::printf("drawing     %s\n%s", error.what(), error.details().c_str());
  } catch (const Error& error) {
    std::printf("drawing     %s\n", error.what());
  }
}

void printSystemInfo() {
  std::printf("limn        %s\n", LIMN_VERSION);
  std::printf("Qt          %s\n", qVersion());
  std::printf("system      %s, %s\n", QSysInfo::prettyProductName().toUtf8().constData(),
              QSysInfo::currentCpuArchitecture().toUtf8().constData());
  std::printf("processor   %s\n", machineName().c_str());
  std::printf("CPU engine  %s\n", CpuRenderer().name().c_str());
  Settings settings;
  EngineFacts engines;
  engines.setting = settings.engine();
  try {
    const HeadlessContext context;
    printDriver(driverFacts());
    printTrial();
    std::printf("filter      %s\n", filterText(filterBits()).c_str());
    engines.renderer = rendererName();
    engines.times = settings.engineMemory().recall(machineWith(engines.renderer));
  } catch (const Error& error) {
    std::printf("OpenGL      none: %s\n", error.what());
    engines.problem = "There is no OpenGL.";
  }
  const EngineChoice choice = chosenEngine(engines);
  std::printf("draws       %s: %s\n", drawsWithOpenGl(choice.engine) ? "OpenGL" : "processor",
              choice.reason.english().c_str());
}

// The volume alone that a picture names, whatever becomes of its labels; nothing where it is elsewhere, which
// a note says.
std::optional<LoadedScene> volumeOfPicture(const SourceArguments& source, const Progress& progress) {
  SourceOptions options = sourceOptions(source);
  options.wantsVolumeAlone = true;
  try {
    return loadScene(source.source, options, progress);
  } catch (const VolumeMissing& missing) {
    if (!source.quiet)
      note(missing.what());
    return std::nullopt;
  }
}

VolumeFacts factsOf(const LoadedScene& loaded, const Progress& progress) {
  VolumeFacts facts;
  facts.volume = loaded.scene.volume;
  if (loaded.dicom)
    facts.series = loaded.dicom->summaries();
  const FoundModuli gradients = findModuli(*facts.volume, 99.5, effortOf(progress, "Measuring gradients"));
  facts.gradientMax = gradients.largest;
  facts.gradientPercentile = gradients.percentile;
  requireWhole(loaded.volumePath, *facts.volume);
  return facts;
}

void runInfo(const InfoArguments& arguments) {
  if (arguments.system) {
    printSystemInfo();
    return;
  }
  const SourceArguments& source = arguments.source;
  if (source.source.empty())
    throw Error(Error::Kind::usage, "limn info needs a volume, such as: limn info head.nii.gz");
  const std::optional<CarriedFacts> picture = carriedFacts(source.source);
  if (picture && !arguments.json)
    printText(*picture);
  const Progress progress = terminalProgress(source.quiet);
  const std::optional<LoadedScene> loaded =
      picture && source.volume.empty() ? volumeOfPicture(source, progress) : loadScene(source, progress);
  if (!loaded && arguments.json)
    std::cout << carriedJson(*picture);
  if (!loaded)
    return;
  const VolumeFacts facts = factsOf(*loaded, progress);
  if (arguments.json)
    std::cout << volumeJson(facts, picture);
  else
    printText(facts);
}

} // namespace

void addInfoCommand(CommandSyntax& root) {
  auto arguments = std::make_shared<InfoArguments>();
  CommandSyntax command = root.command(
      "info", "what a volume is: grid, values, gradients, series, warnings; and what a picture carries");
  addSourceArguments(command, arguments->source,
                     "volume, DICOM folder, scene, picture, `sample` or `phantom:SPACING`");
  command.added("SOURCE").required(false);
  command.flag("--json", arguments->json, "one JSON object on stdout");
  command.flag("--system", arguments->system,
               "versions, renderer and limits for a bug report; nothing personal");
  command.footer("Example: limn info head.nii.gz --json");
  command.runs([arguments] { runInfo(*arguments); });
}

} // namespace limn
