// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"

#include "app/commands/SceneArguments.h"
#include "app/core/drawing/PictureMaker.h"
#include "app/core/making/DicomSaving.h"
#include "app/document/Settings.h"

#include <memory>

namespace limn {
namespace {

struct DicomArguments {
  SceneArguments scene;
  std::string out;
  std::string engine = "auto";
  int threads = 0;
  bool isAnonymous = false;
};

const EngineWords dicomEngines =
    engineWords({Engine::rayCaster, Engine::slices, Engine::cpu, Engine::reference});

void runDicom(const DicomArguments& arguments) {
  const bool isQuiet = arguments.scene.source.quiet;
  const Progress progress = terminalProgress(isQuiet);
  const std::optional<Engine> engine = chosen(dicomEngines, arguments.engine, "--engine");
  requireReportFolder(arguments.out);
  const LoadedScene loaded = loadScene(arguments.scene, progress);
  const SeriesImages series = shownSeries(loaded.volumePath, loaded.dicom, loaded.read.series, progress);
  Scene scene = adjusted(loaded, arguments.scene);
  if (!arguments.scene.model.empty())
    scene.shading.model = modelNamed(arguments.scene.model, "--model");
  Settings settings;
  const MadePicture picture = makePictures({scene}, {scene.image.width, scene.image.height}, engine,
                                           arguments.threads, anyMb, settings.engineMemory())
                                  .front();
  requireWhole(loaded.volumePath, *scene.volume);
  const std::vector<Message> losses =
      saveToDicom(arguments.out, scene, picture.image, series, arguments.isAnonymous, exactnessOf(picture));
  if (isQuiet)
    return;
  for (const Message& remark : remarksOf(picture))
    note(remark.english());
  for (const Message& warning : scene.volume->info().warnings)
    note(warning.english());
  for (const Message& loss : losses)
    note(loss.english());
  if (hasSegments(scene))
    note("segments.dcm holds what is kept and what was cut away, for programs that read segmentations.");
  note(arguments.isAnonymous
           ? "The files leave out what the series says of its patient; its UIDs stay."
           : "The files carry what the series says of its patient; --anonymous leaves it out.");
}

} // namespace

void addDicomCommand(CommandSyntax& root) {
  auto arguments = std::make_shared<DicomArguments>();
  CommandSyntax command = root.command(
      "dicom", "picture and look of a DICOM series as objects for an archive: picture.dcm and look.dcm");
  addSceneArguments(command, arguments->scene, "none, classic, enhanced, robust or physical");
  command
      .option(
          "-o,--output", arguments->out,
          "folder to write picture.dcm and look.dcm to, and segments.dcm where something is kept or cut away")
      .required()
      .folder();
  command
      .option("--engine", arguments->engine,
              "auto (the faster of gl and cpu), gl, slices, cpu, or reference (double precision, slow)")
      .words(wordsOf(dicomEngines));
  command
      .option("--threads", arguments->threads,
              "threads of the CPU engine and the reference (default: every core)")
      .within(1, 4096);
  command.flag("--anonymous", arguments->isAnonymous,
               "leave out what the series says of its patient and study, but for the UIDs by which the look "
               "finds its images");
  command.footer("Example: limn dicom head/ --model classic -o for-the-archive");
  command.runs([arguments] { runDicom(*arguments); });
}

} // namespace limn
