// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/SceneArguments.h"

#include "app/KeptRegion.h"
#include "app/presets/PresetStore.h"
#include "io/looks/Look.h"
#include "scene/framing/Framing.h"
#include "scene/light/ModelName.h"
#include "scene/presets/PresetFit.h"

#include <algorithm>

namespace limn {
namespace {

const std::map<std::string, StandardView> views{
    {"anterior", StandardView::anterior}, {"posterior", StandardView::posterior},
    {"left", StandardView::left},         {"right", StandardView::right},
    {"superior", StandardView::superior}, {"inferior", StandardView::inferior}};

// Own presets were shaped on data like this; built-in ones fit themselves to it.
Preset presetFor(const Volume& volume, const SceneArguments& arguments) {
  const Preset preset = presetNamed(allPresets(PresetStore::ofThisUser()), arguments.preset);
  const std::vector<Preset> builtIn = builtInPresets();
  if (std::find(builtIn.begin(), builtIn.end(), preset) == builtIn.end())
    return preset;
  if (isForHounsfield(preset) && !looksLikeHounsfield(volume) && !arguments.source.quiet)
    note("\"" + preset.name +
         "\" is made for Hounsfield units, which this volume does not have: it may show nothing, "
         "or the wrong tissue.");
  return fittedTo(preset, histogramOf(volume), volume.grid());
}

// A look of Limn's or another program's, with what was changed on the way said.
std::optional<Preset> lookInFile(const Volume& volume, const SceneArguments& arguments) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(arguments.preset, unknown))
    return std::nullopt;
  const Grid& grid = volume.grid();
  const LookTarget target{volume.range().lowest, volume.range().highest,
                          (grid.spacingMm.x + grid.spacingMm.y + grid.spacingMm.z) / 3.0};
  const ReadLook look = readLooks(arguments.preset, target).front();
  if (!arguments.source.quiet)
    for (const Message& change : look.changes)
      note(change.english());
  return look.preset;
}

enum class Keep { all, body };

Region keptBy(Keep keep, const Scene& scene, bool isQuiet) {
  if (keep == Keep::all)
    return {};
  if (scene.keep.kind == Region::Kind::body)
    return scene.keep;
  const FoundRegion found = bodyOf(*scene.volume);
  if (!found.remark.empty() && !isQuiet)
    note(found.remark.english());
  return found.region;
}

} // namespace

ShadingModel modelNamed(const std::string& word, const std::string& option) {
  std::map<std::string, ShadingModel> models;
  for (const ShadingModel model : shadingModels)
    models.emplace(nameOf(model), model);
  return chosen(models, word, option);
}

Camera viewOf(const Scene& scene, const std::string& view, double aspect) {
  return framedView(scene, chosen(views, view, "--view"), aspect);
}

Scene adjusted(const LoadedScene& loaded, const SceneArguments& arguments) {
  Scene scene = loaded.scene;
  if (!arguments.preset.empty()) {
    // A file says how it is lit; a preset by name leaves the model to the scene.
    const std::optional<Preset> look = lookInFile(*scene.volume, arguments);
    scene = look ? withPreset(scene, *look) : withPreset(scene, presetFor(*scene.volume, arguments), true);
  }
  if (!arguments.keep.empty()) {
    const std::map<std::string, Keep> keeps{{"all", Keep::all}, {"body", Keep::body}};
    scene.keep = keptBy(chosen(keeps, arguments.keep, "--keep"), scene, arguments.source.quiet);
  }
  if (arguments.stepVoxels > 0.0 && arguments.toleranceLevels > 0.0)
    throw Error(Error::Kind::usage,
                "--step and --tolerance exclude each other: a tolerance chooses the steps itself.");
  if (arguments.stepVoxels > 0.0) {
    scene.quality.stepVoxels = arguments.stepVoxels;
    scene.quality.toleranceLevels.reset();
    scene.quality.fineness.reset();
  }
  if (arguments.toleranceLevels > 0.0) {
    scene.quality.toleranceLevels = arguments.toleranceLevels;
    scene.quality.fineness.reset();
  }
  if (!arguments.size.empty()) {
    const glm::ivec2 size = parsedSize(arguments.size);
    scene.image.width = size.x;
    scene.image.height = size.y;
  }
  // Half a picture is narrow.
  const double aspect = (arguments.model == "compare" ? 0.5 : 1.0) * scene.image.width / scene.image.height;
  if (!arguments.view.empty())
    scene.camera = viewOf(scene, arguments.view, aspect);
  else if (!loaded.hasOwnCamera)
    scene.camera = framedCamera(scene, aspect);
  return scene;
}

void addSceneArguments(CommandSyntax& command, SceneArguments& arguments, const std::string& models) {
  addSourceArguments(
      command, arguments.source,
      "scene or session file, volume, DICOM folder or look, Limn picture, or `phantom:SPACING`");
  command.option("--size", arguments.size, "WIDTHxHEIGHT in pixels (default: the scene's, 512x512)");
  command.option("--model", arguments.model, models);
  addLookOptions(command, arguments);
}

void addLookOptions(CommandSyntax& command, SceneArguments& arguments) {
  command.option(
      "--preset", arguments.preset,
      "name of a built-in or own preset (see `limn presets list`), or a file with a look (a preset, a DICOM "
      "presentation state); without it the best fitting one");
  command.option("--view", arguments.view, "anterior, posterior, left, right, superior or inferior");
  command.option("--keep", arguments.keep,
                 "all, or body: without the table, the holder and what else lies beside it");
  command.option("--step", arguments.stepVoxels, "sampling step in units of the smallest voxel spacing")
      .within(1e-4, 1e4);
  command
      .option(
          "--tolerance", arguments.toleranceLevels,
          "error-controlled steps that keep within LEVELS of 255 (99.9th percentile) of the exact picture")
      .within(0.01, 255.0);
}

} // namespace limn
