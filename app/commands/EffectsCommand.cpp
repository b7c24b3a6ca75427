// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Commands.h"

#include "app/commands/SceneArguments.h"
#include "app/core/drawing/OnDisk.h"
#include "app/core/drawing/RealRenderers.h"
#include "cpu/CpuCosts.h"
#include "gl/HeadlessContext.h"
#include "gl/PictureTarget.h"
#include "io/reports/ReportJson.h"
#include "raycaster/CasterCosts.h"
#include "scene/PictureFigures.h"

#include <chrono>
#include <cstdio>
#include <iostream>
#include <memory>
#include <thread>

namespace limn {
namespace {

struct EffectsArguments {
  SceneArguments scene;
  int frames = 7;
  bool json = false;
  bool shader = false;
};

// What is told of a scene's effects.
struct Report {
  std::string renderer;
  std::vector<EffectRow> rows;
  std::vector<std::optional<EffectCost>> costs, wouldCosts; ///< one per row: of what is on, and off
  double wholeMs = 0.0;
  std::string method;
  Overflow overflow;
};

// Draws with a ray caster or a CPU engine, and `drawing` with the same.
template <class Renderer>
Report measuredReport(Renderer& renderer, CostedDrawing& drawing, const std::string& name, const Scene& scene,
                      int frames, const Progress& progress) {
  const glm::ivec2 size(scene.image.width, scene.image.height);
  Report report{name, effectRows(scene, renderer.plan(scene)), {}, {}, 0.0, {}, {}};
  EffectCosts costs(scene, size, report.rows, frames);
  costs.addWhatIsOff(drawing);
  while (costs.step(drawing)) {
    if (costs.isWaiting())
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (progress.report)
      progress.report(costs.fraction(), "Measuring the effects");
  }
  if (progress.report)
    progress.report(1.0, "Measuring the effects");
  report.costs = costs.costs();
  report.wouldCosts = costs.wouldCosts();
  report.wholeMs = costs.wholeMs();
  report.method = drawing.method();
  report.overflow = overflowOf(renderer.renderUnlimited(scene, size));
  return report;
}

void printJson(const Report& report) {
  std::cout << effectsJson(report.renderer, report.rows, report.costs, report.wouldCosts);
}

// Why a row is on or off and, where it is known, what it brought to the picture or would cost and bring.
std::string whyAndWhat(const EffectRow& row, const std::optional<EffectCost>& cost,
                       const std::optional<EffectCost>& wouldCost) {
  const std::string why = row.reason.english();
  if (wouldCost)
    return why + "; " + wouldCostText(*wouldCost).english() +
           (wouldCost->brought ? ", " + wouldBringText(*wouldCost->brought).english() : std::string());
  return cost && cost->brought ? why + "; " + broughtText(*cost->brought).english() : why;
}

std::string methodLine(const Report& report, const Scene& scene, int frames) {
  if (isPhysical(scene))
    return "Physical light is drawn as a whole by " + report.renderer + "; no effect has a cost of its own";
  char text[400];
  std::snprintf(text, sizeof text,
                "%d x %d pixels take %.1f ms on %s; each cost is the median of %d pictures less the median "
                "of %d without the effect, drawn in turn (costs overlap and do not add up); %s",
                scene.image.width, scene.image.height, report.wholeMs, report.renderer.c_str(), frames,
                frames, report.method.c_str());
  return text;
}

void printTable(const Report& report, const Scene& scene, int frames) {
  std::printf("%-21s %-4s %22s %8s  %s\n", "effect", "", "ms", "+-", "why");
  for (std::size_t i = 0; i < report.rows.size(); ++i) {
    const EffectRow& row = report.rows[i];
    std::printf("%-21s %-4s ", row.name.c_str(), row.isOn ? "on" : "off");
    if (const auto& cost = report.costs[i])
      std::printf("%22s %8.1f", costText(*cost).english().c_str(), cost->spreadMs);
    else
      std::printf("%22s %8s", "", "");
    std::printf("  %s\n", whyAndWhat(row, report.costs[i], report.wouldCosts[i]).c_str());
  }
  std::printf("\n%s.\n", methodLine(report, scene, frames).c_str());
  if (!isPhysical(scene))
    std::printf("Before it is limited, light overflows in %.2f %% of the pixels, by %.3f on average.\n",
                100.0 * report.overflow.share, report.overflow.meanOvershoot);
}

Report reportWithOpenGl(const Scene& scene, int frames, const Progress& progress) {
  const HeadlessContext context;
  RayCaster caster;
  CasterCosts drawing(caster);
  const FloatTarget target({scene.image.width, scene.image.height});
  return measuredReport(caster, drawing, rendererName(), scene, frames, progress);
}

Report reportOnProcessor(const Scene& scene, int frames, const Progress& progress) {
  CpuRenderer renderer(0, CpuRenderer::Tolerance::stepsFirst); // as pictures are drawn
  if (isPhysical(scene)) { // its paths are followed once, not with and without something
    Report report{renderer.name(), effectRows(scene, renderer.plan(scene)), {}, {}, 0.0, {}, {}};
    report.costs.resize(report.rows.size());
    report.wouldCosts.resize(report.rows.size());
    return report;
  }
  CpuCosts drawing(renderer);
  return measuredReport(renderer, drawing, renderer.name(), scene, frames, progress);
}

void printShader(const Scene& scene) {
  requireOpenGlMayCopy(scene, "");
  const HeadlessContext context;
  RayCaster caster;
  const std::string text = caster.fragmentShader(scene);
  if (text.empty())
    throw Error(Error::Kind::usage, "Nothing of the volume can be seen, so there is no shader; give the "
                                    "transfer function some opacity within the volume's values.");
  std::cout << text;
}

void runEffects(const EffectsArguments& arguments) {
  const SourceArguments& source = arguments.scene.source;
  const Progress progress = terminalProgress(source.quiet);
  const LoadedScene loaded = loadScene(arguments.scene, progress);
  Scene scene = adjusted(loaded, arguments.scene);
  if (!arguments.scene.model.empty())
    scene.shading.model = modelNamed(arguments.scene.model, "--model");
  if (arguments.shader)
    return printShader(scene);
  const Report report = raysAtHand(scene) == Engine::rayCaster
                            ? reportWithOpenGl(scene, arguments.frames, progress)
                            : reportOnProcessor(scene, arguments.frames, progress);
  requireWhole(loaded.volumePath, *scene.volume);
  if (arguments.json) {
    printJson(report);
    if (!source.quiet)
      note(methodLine(report, scene, arguments.frames) + ".");
  } else {
    printTable(report, scene, arguments.frames);
  }
  if (!source.quiet && arguments.scene.preset.empty() && !loaded.preset.empty())
    note("Measured with the preset \"" + loaded.preset + "\".");
}

} // namespace

void addEffectsCommand(CommandSyntax& root) {
  auto arguments = std::make_shared<EffectsArguments>();
  CommandSyntax command =
      root.command("effects", "which effects a picture simulates, why, and what each costs");
  addSceneArguments(command, arguments->scene, "none, classic, enhanced, robust or physical");
  command.option("--frames", arguments->frames, "pictures per effect of which the median counts")
      .within(5, 1000);
  command.flag("--json", arguments->json, "one JSON object on stdout");
  command.flag("--shader", arguments->shader, "print the assembled GLSL instead");
  command.footer("Example: limn effects head.nii.gz --model enhanced --size 800x600");
  command.runs([arguments] { runEffects(*arguments); });
}

} // namespace limn
