// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"

#include "app/commands/Arguments.h"
#include "app/core/drawing/ProcessCost.h"
#include "app/document/Settings.h"
#include "cpu/CpuRenderer.h"
#include "gl/DriverHealth.h"
#include "gl/HeadlessContext.h"
#include "glsl/programs/FilterBits.h"
#include "io/reports/ReportJson.h"
#include "raycaster/RayCaster.h"
#include "scene/basics/Error.h"
#include "scene/light/ModulusSearch.h"
#include "scene/volume/Phantom.h"

#include <QString>
#include <QSysInfo>
#include <QtGlobal>

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

void runInfo(const InfoArguments& arguments) {
  if (arguments.system) {
    printSystemInfo();
    return;
  }
  if (arguments.source.source.empty())
    throw Error(Error::Kind::usage, "limn info needs a volume, such as: limn info head.nii.gz");
  VolumeFacts facts;
  const Progress progress = terminalProgress(arguments.source.quiet);
  const LoadedScene loaded = loadScene(arguments.source, progress);
  facts.volume = loaded.scene.volume;
  if (loaded.dicom)
    facts.series = loaded.dicom->summaries();
  const FoundModuli gradients = findModuli(*facts.volume, 99.5, effortOf(progress, "Measuring gradients"));
  facts.gradientMax = gradients.largest;
  facts.gradientPercentile = gradients.percentile;
  requireWhole(loaded.volumePath, *facts.volume);
  if (arguments.json)
    std::cout << volumeJson(facts);
  else
    printText(facts);
}

} // namespace

void addInfoCommand(CommandSyntax& root) {
  auto arguments = std::make_shared<InfoArguments>();
  CommandSyntax command = root.command("info", "what a volume is: grid, values, gradients, series, warnings");
  addSourceArguments(command, arguments->source,
                     "volume, DICOM folder, scene, `sample` or `phantom:SPACING`");
  command.added("SOURCE").required(false);
  command.flag("--json", arguments->json, "one JSON object on stdout");
  command.flag("--system", arguments->system,
               "versions, renderer and limits for a bug report; nothing personal");
  command.footer("Example: limn info head.nii.gz --json");
  command.runs([arguments] { runInfo(*arguments); });
}

} // namespace limn
