// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"

#include "app/commands/SceneArguments.h"
#include "app/core/making/Turntable.h"
#include "app/document/PrivateNames.h"
#include "app/document/Settings.h"
#include "io/AtomicFile.h"
#include "io/scenefile/SceneFile.h"
#include "scene/framing/VisibleVoxels.h"
#include "widgets/controls/TimeLeft.h"
#include "widgets/view/overlay/Titles.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>

namespace limn {
namespace {

struct TurntableArguments {
  SceneArguments scene;
  std::string out;
  std::string engine = "auto";
  int threads = 0;
  int frames = 90;
  double framesPerSecond = 25.0;
};

const EngineWords turntableEngines = engineWords({Engine::rayCaster, Engine::cpu});

// Says which frame is drawn and how long the rest takes: on a terminal in one line, elsewhere, such as in a
// file of what was said, in a line now and then.
class FrameTeller {
public:
  FrameTeller(int frames, bool isVideo, const Progress& terminal)
      : m_frames(frames), m_isVideo(isVideo), m_terminal(terminal) {
    m_left.begin(1, std::min(aHundredth, 1.0 / frames));
  }

  void operator()(double fraction) {
    const double drawn = shareDrawn(fraction, m_isVideo);
    const int frame = std::min(m_frames, static_cast<int>(drawn * m_frames) + 1);
    const std::string what = "Drawing frame " + std::to_string(frame) + " of " + std::to_string(m_frames) +
                             m_left.text(drawn).toStdString();
    if (m_terminal.report)
      return m_terminal.report(fraction, what);
    constexpr std::chrono::seconds pause(10);
    if (const auto now = std::chrono::steady_clock::now(); !m_told || now - *m_told >= pause) {
      m_told = now;
      note(what + ".");
    }
  }

private:
  int m_frames;
  bool m_isVideo;
  const Progress& m_terminal;
  TimeLeft m_left;
  std::optional<std::chrono::steady_clock::time_point> m_told;
};

// What its frames do not tell whoever sees them: what is hidden, and of a video, which carries no scene, the
// model in any case. Empty where there is nothing.
std::string untold(const Scene& scene, bool isVideo) {
  Comparison shown;
  shown.scene = scene;
  shown.cropHidesNothing = scene.crop != CropBox{} && cropsOnlyUnseen(scene);
  QStringList parts{sideTitle(scene)};
  if (const QString hidden = hiddenText(shown); !hidden.isEmpty())
    parts << hidden;
  else if (!isVideo)
    return {};
  return "The frames do not say what they show: " + parts.join(QStringLiteral(" · ")).toStdString() + ".";
}

// What would be refused after the work is refused before it.
void requirePlace(const std::string& out, int frames) {
  if (isVideo(out))
    requireWritable(out);
  else
    requireReportFolder(out);
  requireTurntablePlace(out, frames);
}

void runTurntable(const TurntableArguments& arguments) {
  requirePlace(arguments.out, arguments.frames);
  const bool isQuiet = arguments.scene.source.quiet;
  const Progress progress = terminalProgress(isQuiet);
  const LoadedScene loaded = loadScene(arguments.scene, progress);
  Turntable turntable;
  turntable.scene = adjusted(loaded, arguments.scene);
  if (!arguments.scene.model.empty())
    turntable.scene.shading.model = modelNamed(arguments.scene.model, "--model");
  turntable.size = {turntable.scene.image.width, turntable.scene.image.height};
  turntable.frames = arguments.frames;
  turntable.framesPerSecond = arguments.framesPerSecond;
  Settings settings;
  MakingOptions order;
  order.engine = chosen(turntableEngines, arguments.engine, "--engine");
  order.memory = settings.engineMemory();
  order.effort.threads = arguments.threads;
  FrameTeller teller(turntable.frames, isVideo(arguments.out), progress);
  if (!isQuiet)
    order.effort.report = std::ref(teller);
  const DescribeScene describe = [&](const Scene& scene) {
    requireWhole(loaded.volumePath, *scene.volume); // before each frame is written
    const auto shareable = [&](const std::string& path) {
      return shareableName(QString::fromStdString(path), *scene.volume).toStdString();
    };
    Scene written = scene;
    nameSources(written.keep, shareable);
    SceneDocument document = documentOf(written, shareable(loaded.volumePath));
    document.measurements = loaded.measurements;
    document.sides.emplace(); // one picture
    return sceneToJson(document);
  };
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Message> notes = writeTurntable(arguments.out, turntable, order, describe);
  if (isQuiet)
    return;
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  for (const Message& sentence : notes)
    note(sentence.english());
  if (const std::string sentence = untold(turntable.scene, isVideo(arguments.out)); !sentence.empty())
    note(sentence);
  char line[120];
  std::snprintf(line, sizeof line, ": %d frames of %d x %d pixels in %.1f s (set-up included)",
                turntable.frames, turntable.size.x, turntable.size.y, seconds.count());
  note(arguments.out + line);
}

} // namespace

void addTurntableCommand(CommandSyntax& root) {
  auto arguments = std::make_shared<TurntableArguments>();
  CommandSyntax command =
      root.command("turntable", "pictures of a scene or volume from all around, as frames or a video");
  addSceneArguments(command, arguments->scene,
                    "none, classic, enhanced, robust or physical (random paths, by the processor: slow)");
  command.option("-o,--output", arguments->out, "a folder for frames, or a video: .mp4 (with ffmpeg)")
      .required()
      .file({".mp4"});
  command.option("--frames", arguments->frames, "for one turn (default 90)").within(2, mostFrames);
  command.option("--fps", arguments->framesPerSecond, "frames per second of a video (default 25)")
      .within(1.0, 240.0);
  command.option("--engine", arguments->engine, "auto (the faster of gl and cpu), gl or cpu")
      .words(wordsOf(turntableEngines));
  command.option("--threads", arguments->threads, "threads of the CPU engine (default: every core)")
      .within(1, 4096);
  command.footer("Example: limn turntable head.nii.gz --frames 120 --size 800x800 -o head.mp4");
  command.runs([arguments] { runTurntable(*arguments); });
}

} // namespace limn
