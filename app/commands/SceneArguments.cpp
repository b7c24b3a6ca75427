// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/SceneArguments.h"

#include "app/commands/NamedLook.h"
#include "app/core/making/Turntable.h"
#include "app/core/sources/KeptRegion.h"
#include "app/presets/PresetStore.h"
#include "scene/framing/Framing.h"
#include "scene/light/LightPresets.h"
#include "scene/light/Shading.h"

namespace limn {
namespace {

const std::map<std::string, StandardView> views{
    {"anterior", StandardView::anterior}, {"posterior", StandardView::posterior},
    {"left", StandardView::left},         {"right", StandardView::right},
    {"superior", StandardView::superior}, {"inferior", StandardView::inferior}};

/// A part of a turn: "3/36".
struct TurnPart {
  int part;
  int parts;
};

TurnPart turnPartOf(const std::string& turn) {
  int part = 0, parts = 0, end = 0;
  const int found = std::sscanf(turn.c_str(), "%d/%d%n", &part, &parts, &end);
  if (found != 2 || static_cast<std::size_t>(end) != turn.size() || parts < 1)
    throw Error(Error::Kind::usage, "--turn is a part of a turn, such as 3/36; this is \"" + turn + "\".");
  return {part, parts};
}

enum class Keep { all, body };

const std::map<std::string, Keep> keeps{{"all", Keep::all}, {"body", Keep::body}};

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

std::map<std::string, LightPreset> lights() {
  std::map<std::string, LightPreset> words;
  for (const LightPreset preset : lightPresets)
    words.emplace(nameOf(preset), preset);
  return words;
}

} // namespace

std::vector<std::string> modelWords() {
  std::vector<std::string> words;
  words.reserve(shadingModels.size());
  for (const ShadingModel model : shadingModels)
    words.emplace_back(nameOf(model));
  return words;
}

std::vector<std::string> modelWordsAndCompare() {
  std::vector<std::string> words = modelWords();
  words.emplace_back("compare");
  return words;
}

std::vector<std::string> lightWords() {
  return wordsOf(lights());
}

std::vector<std::string> viewWords() {
  return wordsOf(views);
}

std::vector<std::string> keepWords() {
  return wordsOf(keeps);
}

std::vector<std::string> presetWords() {
  std::vector<std::string> words;
  for (const Preset& preset : builtInPresets())
    words.push_back(preset.name);
  return words;
}

std::vector<std::string> lookEndings() {
  std::vector<std::string> endings{".dcm"};
  for (const LookFormat& format : lookFormats())
    endings.insert(endings.end(), format.endings.begin(), format.endings.end());
  return endings;
}

ShadingModel modelNamed(const std::string& word, const std::string& option) {
  std::map<std::string, ShadingModel> models;
  for (const ShadingModel model : shadingModels)
    models.emplace(nameOf(model), model);
  return chosen(models, word, option);
}

StandardView viewNamed(const std::string& word) {
  return chosen(views, word, "--view");
}

Camera viewOf(const Scene& scene, const std::string& view, double aspect) {
  return framedView(scene, viewNamed(view), aspect);
}

LoadedScene loadScene(const SceneArguments& arguments, const Progress& progress) {
  return loadScene(arguments.source, progress, !arguments.view.empty());
}

Scene adjusted(const LoadedScene& loaded, const SceneArguments& arguments) {
  Scene scene = loaded.scene;
  if (!arguments.preset.empty())
    scene = withPreset(scene, presetAskedFor(arguments.preset, *scene.volume, arguments.source.quiet),
                       !arguments.model.empty() || !namesLookFile(arguments.preset));
  if (!arguments.light.empty())
    scene.shading = withLight(scene.shading, chosen(lights(), arguments.light, "--light"));
  if (!arguments.keep.empty())
    scene.keep = keptBy(chosen(keeps, arguments.keep, "--keep"), scene, arguments.source.quiet);
  if (arguments.stepVoxels > 0.0 && arguments.toleranceLevels > 0.0)
    throw Error(Error::Kind::usage,
                "--step and --tolerance exclude each other: a tolerance chooses the steps itself.");
  if (arguments.stepVoxels > 0.0) {
    scene.quality.stepVoxels = arguments.stepVoxels;
    scene.quality.toleranceLevels.reset();
    scene.quality.fineness.reset();
    scene.quality.ownWeights = false;
  }
  if (arguments.toleranceLevels > 0.0) {
    scene.quality.toleranceLevels = arguments.toleranceLevels;
    scene.quality.fineness.reset();
    scene.quality.ownWeights = false;
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
  if (!arguments.turn.empty()) {
    const TurnPart turn = turnPartOf(arguments.turn);
    scene.camera = Turn(scene, turn.parts, aspect, aspect).view(turn.part);
  }
  return scene;
}

void addSceneArguments(CommandSyntax& command, SceneArguments& arguments, const std::string& models) {
  addSourceArguments(
      command, arguments.source,
      "scene or session file, volume, DICOM folder or look, Limn picture, `sample` or `phantom:SPACING`");
  command.option("--size", arguments.size,
                 "WIDTHxHEIGHT in pixels (default: that of the picture or scene, 512x512 of a volume)");
  command.option("--model", arguments.model, models)
      .words(models.find("compare") == std::string::npos ? modelWords : modelWordsAndCompare);
  addLookOptions(command, arguments);
}

void addLookOptions(CommandSyntax& command, SceneArguments& arguments) {
  command
      .option("--preset", arguments.preset,
              "name of a built-in or own preset (see `limn presets list`), or a file with a look of Limn or "
              "another program (see `limn presets convert --help`) or of an archive; without it the best "
              "fitting one")
      .words(presetWords)
      .file(lookEndings());
  command
      .option("--light", arguments.light,
              "headlight, studio (a lamp above and to the left that turns with the view, with shadows), "
              "soft-studio, overcast, or physical (the studio's lamp and a sky in physical light)")
      .words(lightWords);
  command.option("--view", arguments.view, "anterior, posterior, left, right, superior or inferior")
      .words(viewWords);
  command.option("--turn", arguments.turn,
                 "turned about the patient's upright axis by a part of a turn, such as 3/36");
  command
      .option("--keep", arguments.keep,
              "all, or body: without the table, the holder and what else lies beside it")
      .words(keepWords);
  command.option("--step", arguments.stepVoxels, "sampling step in units of the smallest voxel spacing")
      .within(1e-4, 1e4);
  command
      .option(
          "--tolerance", arguments.toleranceLevels,
          "error-controlled steps that by an estimate keep within LEVELS of 255 (99.9th percentile) of the "
          "exact picture; what pixels drawn at random say of it is printed")
      .within(0.01, 255.0);
}

} // namespace limn
