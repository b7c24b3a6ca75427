// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"
#include "app/commands/RenderWork.h"

#include "accuracy/SamplePicture.h"
#include "app/commands/NamedLook.h"
#include "app/core/drawing/ComparedSides.h"
#include "app/core/drawing/PathDrawing.h"
#include "app/core/drawing/StatedAccuracy.h"
#include "app/document/PrivateNames.h"
#include "app/document/Settings.h"
#include "io/AtomicFile.h"
#include "io/ImageFile.h"
#include "io/reports/ReportJson.h"
#include "io/scenefile/SceneFile.h"
#include "scene/basics/Error.h"
#include "scene/effects/EffectPlan.h"
#include "scene/light/LightPresets.h"
#include "scene/presets/PresetFit.h"

#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>
#include <memory>

namespace limn {
namespace {

const EngineWords engines = engineWords({allEngines.begin(), allEngines.end()});

// Whether something was asked for that is of one model alone.
bool asksForOneModel(const RenderArguments& arguments) {
  const SceneArguments& asked = arguments.scene;
  return !asked.model.empty() || asked.light == nameOf(LightPreset::physical) ||
         namesLookFile(asked.preset) || arguments.filtersNoise || arguments.printsFigures ||
         !arguments.samplesSpent.empty();
}

// The same of two looks: one that is named takes the place of both.
bool asksForOneLook(const RenderArguments& arguments) {
  return asksForOneModel(arguments) || !arguments.scene.preset.empty() || !arguments.scene.light.empty();
}

// How many are drawn, and which: of a picture those that it shows, if nobody asks for others.
ShownSides sidesOf(const RenderArguments& arguments, const LoadedScene& loaded) {
  if (arguments.scene.model == "compare")
    return {CompareLayout::sideBySide, ShadingModel::classic, ShadingModel::enhanced};
  const ShownSides sides = loaded.sides.value_or(ShownSides{});
  return (sides.look ? asksForOneLook(arguments) : asksForOneModel(arguments)) ? ShownSides{} : sides;
}

// A scene tells the size of one side.
Scene sceneAsked(LoadedScene loaded, SceneArguments arguments, const ShownSides& sides) {
  if (sides.layout != CompareLayout::sideBySide)
    return adjusted(loaded, arguments);
  if (loaded.sides && loaded.sides->layout == CompareLayout::sideBySide)
    loaded.scene.image.width *= 2;
  arguments.model = "compare";
  Scene scene = adjusted(loaded, arguments);
  scene.image.width /= 2;
  if (scene.image.width < 1)
    throw Error(Error::Kind::usage, "A comparison needs a picture at least two pixels wide; see --size.");
  return scene;
}

// What the second side has to tell beside the first.
void addNotes(const std::vector<Message>& more, std::vector<Message>& notes) {
  for (const Message& note : more)
    if (std::ranges::find(notes, note) == notes.end())
      notes.push_back(note);
}

MadePicture pictureOf(const Scene& scene, const ShownSides& sides, const MakeAll& make) {
  const glm::ivec2 size(scene.image.width, scene.image.height);
  std::vector<MadePicture> pair = make(scenesShown(scene, sides), size);
  MadePicture& both = pair.front();
  if (sides.layout == CompareLayout::single)
    return std::move(both);
  both.image =
      comparedPicture(both.image, pair.back().image, sides.layout, sides.wipe, scene.image.background);
  addNotes(pair.back().notes, both.notes);
  return std::move(both);
}

// What of a picture of two is left out, because something was asked for that is of one.
std::string leftOutNote(const LoadedScene& loaded, const Scene& scene, const ShownSides& sides) {
  if (!loaded.sides || loaded.sides->layout == CompareLayout::single || sides.layout != CompareLayout::single)
    return {};
  if (loaded.sides->look)
    return "The picture shows two looks; one was asked for, and the right one, which options change, is "
           "drawn.";
  return std::string("The picture shows two models, ") + nameOf(loaded.sides->left) + " and " +
         nameOf(loaded.sides->right) + "; one was asked for, and " + nameOf(scene.shading.model) +
         " is drawn.";
}

// Pictures that were saved before they told their sides hold one of two.
std::string lostLookNote(const std::string& source, const LoadedScene& loaded) {
  if (loaded.sides || loaded.beside || carriedBy(source).empty())
    return {};
  const ImageSettings& its = loaded.scene.image;
  const bool areTwo = readImageSize(source) == glm::ivec2(2 * its.width, its.height);
  return areTwo ? "The picture shows two side by side, of which its file holds one; that is drawn."
                : std::string();
}

PictureFigures measured(const Scene& scene, Engine engine, int threads) {
  return measureFigures(scene, {scene.image.width, scene.image.height}, engine, threads);
}

void print(const PictureFigures& figures, const Scene& scene) {
  std::printf("contrast %.4f; highlights overflow in %.2f %% of the pixels, by %.3f on average; %.1f %% of "
              "what lies at or above %g%s can be seen\n",
              figures.contrast, 100.0 * figures.overflow.share, figures.overflow.meanOvershoot,
              100.0 * figures.visibleShare, scene.isovalue, looksLikeHounsfield(*scene.volume) ? " HU" : "");
}

// The CPU engine counts none: where it was not asked for, the reference does, which takes the same ones.
void writeSamples(const MadePicture& picture, const RenderArguments& arguments) {
  const Scene& scene = picture.scene;
  const glm::ivec2 size(scene.image.width, scene.image.height);
  const bool isOpen = arguments.engine == "auto" && picture.drawnBy == Engine::cpu;
  const std::vector<int> samples =
      countSamples(scene, size, isOpen ? Engine::reference : picture.drawnBy, arguments.threads);
  writeImage(arguments.samplesSpent, pictureOfSamples(samples, size), glm::dvec3(0.0), {});
  const SampleFigures figures = figuresOf(samples);
  char line[128];
  std::snprintf(line, sizeof line, "Samples spent by a ray: %d to %d (pale yellow), %.0f on average.",
                figures.least, figures.most, figures.mean);
  note(line);
}

// Whoever asks for a tolerance is told what it came to, and of more than that by a note.
std::optional<PictureAccuracy> accuracyOf(const Scene& asked, MadePicture& picture, int threads,
                                          const Progress& progress) {
  if (picture.paths)
    return accuracyOf(*picture.paths);
  if (!asked.quality.toleranceLevels)
    return std::nullopt;
  reportOrStop(progress, -1.0, "Integrating some pixels exactly");
  const std::optional<ErrorByChance> chance = chanceOf(picture.scene, picture.image, {threads, {}, {}});
  reportOrStop(progress, 1.0, "Integrating some pixels exactly");
  if (!chance)
    return std::nullopt;
  if (const Message note = noteBeyondTolerance(asked, *chance); !note.empty())
    picture.notes.push_back(note);
  return accuracyByChance(*chance);
}

void printJson(const MadePicture& picture, const std::string& out, double ms,
               const std::optional<PictureAccuracy>& accuracy, const std::optional<PictureFigures>& figures) {
  PictureReport drawn{out, picture.image.size, picture.engine, ms, {}, {}, figures, {}};
  if (accuracy) {
    drawn.withinLevels = accuracy->levels;
    drawn.statement = accuracy->sentence;
  }
  for (const Message& remark : remarksOf(picture))
    drawn.notes.push_back(remark.english());
  if (picture.paths)
    drawn.paths = {picture.paths->paths, picture.paths->rmsLevels, picture.paths->p99_9Levels,
                   picture.pathSeconds, picture.paths->filtered.has_value()};
  std::cout << pictureJson(drawn);
}

} // namespace

void runRender(const RenderArguments& arguments, const MakeAll& make) {
  if (arguments.textureMb != anyMb && arguments.engine != "auto" && arguments.engine != "gl")
    throw Error(Error::Kind::usage,
                "--texture-mb limits the ray caster alone; use it with --engine auto or gl.");
  if (arguments.skipsExisting && isWholePicture(arguments.out))
    return;
  for (const std::string& picture : {arguments.out, arguments.samplesSpent})
    if (!picture.empty()) {
      requirePictureEnding(picture);
      requireWritable(picture);
    }
  const Progress progress = terminalProgress(arguments.scene.source.quiet);
  const LoadedScene loaded = loadScene(arguments.scene, progress);
  const ShownSides sides = sidesOf(arguments, loaded);
  const bool isComparison = sides.layout != CompareLayout::single;
  if (isComparison && !arguments.samplesSpent.empty())
    throw Error(Error::Kind::usage, "--samples-spent counts one model at a time; choose one with --model.");
  if (isComparison && arguments.printsFigures)
    throw Error(Error::Kind::usage, "--figures measures one model at a time; choose one with --model.");
  Scene scene = sceneAsked(loaded, arguments.scene, sides);
  if (!arguments.scene.model.empty() && !isComparison)
    scene.shading.model = modelNamed(arguments.scene.model, "--model (beside compare)");
  if (arguments.filtersNoise && (isComparison || !isPhysical(scene)))
    throw Error(Error::Kind::usage,
                "--filter-noise filters pictures of random paths; use it with --model physical.");
  scene.shading.physical.filtersNoise |= arguments.filtersNoise;
  const auto start = std::chrono::steady_clock::now();
  reportOrStop(progress, -1.0, "Drawing");
  MadePicture picture = pictureOf(scene, sides, make);
  reportOrStop(progress, 1.0, "Drawing");
  requireWhole(loaded.volumePath, *scene.volume);
  const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
  // The picture may travel: it names its volume without folders, and nobody.
  const auto shareable = [&scene](const std::string& path) {
    return shareableName(QString::fromStdString(path), *scene.volume).toStdString();
  };
  std::optional<PictureFigures> figures;
  if (arguments.printsFigures && isPhysical(scene))
    throw Error(Error::Kind::usage,
                "--figures measures pictures whose samples are lit; choose another --model.");
  if (arguments.printsFigures)
    figures = measured(scene, picture.drawnBy, arguments.threads);
  if (figures && !arguments.json)
    print(*figures, scene);
  if (!arguments.samplesSpent.empty())
    writeSamples(picture, arguments);
  Scene written = isComparison ? scene : picture.scene;
  nameSources(written.keep, shareable);
  const std::optional<PictureAccuracy> accuracy =
      isComparison ? std::nullopt : accuracyOf(scene, picture, arguments.threads, progress);
  SceneDocument document = documentOf(written, shareable(loaded.volumePath));
  document.measurements = loaded.measurements;
  document.sides = sides;
  writeImage(arguments.out, picture.image, scene.image.background, sceneToJson(document, accuracy),
             isComparison ? Image{} : picture.radiance);
  if (arguments.json)
    printJson(picture, arguments.out, ms.count(), accuracy, figures);
  if (arguments.scene.source.quiet)
    return;
  if (arguments.scene.preset.empty() && !loaded.preset.empty())
    note("Shown with the preset \"" + loaded.preset + "\".");
  if (const std::string leftOut = leftOutNote(loaded, scene, sides); !leftOut.empty())
    note(leftOut);
  if (const std::string lost = lostLookNote(arguments.scene.source.source, loaded); !lost.empty())
    note(lost);
  for (const Message& warning : scene.volume->info().warnings)
    note(warning.english());
  for (const Message& remark : remarksOf(picture))
    note(remark.english());
  if (accuracy && !picture.paths) // of paths it was said
    note(accuracy->sentence);
  char line[160];
  std::snprintf(line, sizeof line, ": %d x %d pixels in %.0f ms (set-up included) on %s",
                picture.image.size.x, picture.image.size.y, ms.count(), picture.engine.c_str());
  note(arguments.out + line);
}

std::vector<std::string> renderEngineWords() {
  return wordsOf(engines);
}

void addRenderOptions(CommandSyntax& command, RenderArguments& arguments) {
  addSceneArguments(
      command, arguments.scene,
      "none, classic, enhanced, robust, physical (random paths, by the processor), or compare (classic "
      "and enhanced side by side)");
  command.option("-o,--output", arguments.out, "picture to write: .png .tif .jpg .exr")
      .required()
      .file({".png", ".tif", ".jpg", ".exr"});
  command
      .option(
          "--engine", arguments.engine,
          "auto (the faster of gl and cpu), gl (ray caster), slices (view-aligned slices blended front to "
          "back), slices-back-to-front, cpu, or reference (double precision, slow)")
      .words(renderEngineWords);
  command
      .option("--threads", arguments.threads,
              "threads of the CPU engine and the reference (default: every core)")
      .within(1, 4096);
  command.flag("--json", arguments.json, "one JSON object on stdout: what was drawn, by whom, and its error");
  command.flag("--filter-noise", arguments.filtersNoise,
               "with --model physical: filter the noise that is left, and print what that changed and what "
               "error remains (an EXR keeps the radiance as paths found it)");
  command.flag("--figures", arguments.printsFigures,
               "print contrast, overflow of highlights, and how much can be seen of what lies at or above "
               "the scene's isovalue (300 if not set)");
  command
      .option("--samples-spent", arguments.samplesSpent,
              "also write how many samples each pixel took, as a picture: .png .tif .jpg .exr")
      .file({".png", ".tif", ".jpg", ".exr"});
  command
      .option("--texture-mb", arguments.textureMb,
              "the most that the volume may take on the graphics card, MB; a larger one is drawn by the "
              "processor (--engine auto) or with fewer voxels (--engine gl; default: what the driver takes)")
      .within(1.0, 1e6);
  command.flag("--skip-existing", arguments.skipsExisting,
               "draw nothing where the picture is there and whole: work that was interrupted goes on");
}

void addRenderCommand(CommandSyntax& root) {
  auto arguments = std::make_shared<RenderArguments>();
  CommandSyntax command = root.command("render", "a picture of a scene or volume");
  addRenderOptions(command, *arguments);
  command.footer("Example: limn render head.nii.gz --model compare --size 1200x600 -o compare.png");
  command.runs([arguments] {
    const std::optional<Engine> engine = chosen(engines, arguments->engine, "--engine");
    runRender(*arguments, [&](const std::vector<Scene>& scenes, const glm::ivec2& size) {
      const Progress progress = terminalProgress(arguments->scene.source.quiet);
      const auto report = [&progress](double fraction) { reportOrStop(progress, fraction, "Drawing"); };
      Settings settings; // which what is remembered of engines refers to
      MakingOptions order{
          engine, arguments->textureMb, settings.engineMemory(), {arguments->threads, {}, report}};
      order.tellsFilter = std::ranges::any_of(scenes, hasTravellingLight); // of few paths
      std::vector<MadePicture> pictures;
      makeEach(scenes, size, order,
               [&pictures](std::size_t, MadePicture picture) { pictures.push_back(std::move(picture)); });
      return pictures;
    });
  });
}

} // namespace limn
