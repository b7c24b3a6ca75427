// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/InfoCommand.h"

#include "app/commands/Arguments.h"
#include "app/commands/SystemInfo.h"
#include "io/reports/ReportJson.h"
#include "scene/basics/Error.h"
#include "scene/light/Gradient.h"

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
  std::printf("type        %s, value = %.6g * stored + %.6g\n", voxelTypeName(volume.stored()).c_str(),
              volume.rescale().slope, volume.rescale().intercept);
  std::printf("range       %.6g to %.6g%s\n", volume.range().lowest, volume.range().highest, unit.c_str());
  std::printf("invalid     %zu voxels\n", volume.invalidVoxels());
  std::printf("gradient    largest %.6g, 99.5th percentile %.6g %s\n", facts.gradientMax,
              facts.gradientPercentile, perMm.c_str());
  for (const SeriesSummary& series : facts.series)
    std::printf("series %-4d %s %d x %d x %d %s\n", series.number, series.modality.c_str(), series.dims.x,
                series.dims.y, series.dims.z, series.description.c_str());
  for (const std::string& warning : volume.info().warnings)
    std::printf("warning     %s\n", warning.c_str());
}

void runInfo(const InfoArguments& arguments) {
  if (arguments.system) {
    printSystemInfo();
    return;
  }
  if (arguments.source.source.empty())
    throw Error(Error::Kind::usage, "limn info needs a volume, such as: limn info head.nii.gz");
  VolumeFacts facts;
  const LoadedScene loaded = loadScene(arguments.source.source, sourceOptions(arguments.source),
                                       terminalProgress(arguments.source.quiet));
  facts.volume = loaded.scene.volume;
  if (std::filesystem::exists(loaded.volumePath))
    facts.series = listSeries(loaded.volumePath);
  facts.gradientMax = largestGradient(*facts.volume);
  facts.gradientPercentile = gradientPercentile(*facts.volume, 99.5);
  if (arguments.json)
    std::cout << volumeJson(facts);
  else
    printText(facts);
}

} // namespace

void addInfoCommand(CommandSyntax& root) {
  auto arguments = std::make_shared<InfoArguments>();
  CommandSyntax command = root.command("info", "what a volume is: grid, values, gradients, series, warnings");
  addSourceArguments(command, arguments->source, "volume, DICOM folder, scene, or `phantom:SPACING`");
  command.added("SOURCE").required(false);
  command.flag("--json", arguments->json, "one JSON object on stdout");
  command.flag("--system", arguments->system,
               "versions, renderer and limits for a bug report; nothing personal");
  command.footer("Example: limn info head.nii.gz --json");
  command.runs([arguments] { runInfo(*arguments); });
}

} // namespace limn
