// SPDX-License-Identifier: GPL-3.0-or-later
// How many levels a picture at rest is away from the exact one 2 and 15 s after it was complete, by the error
// stated and in truth: a volume in its best-fitting preset, classic and enhanced, 900×640, refined as the
// window does it, by OpenGL and by the CPU engine. The exact picture is one of error-controlled steps whose
// error is less than a hundredth of a level.
//
// limn_refinement_time VOLUME...
#include "accuracy/ImageError.h"
#include "cpu/CpuEngine.h"
#include "cpu/CpuRenderer.h"
#include "gl/HeadlessContext.h"
#include "io/VolumeReader.h"
#include "io/scenefile/SceneFile.h"
#include "raycaster/RayCasterEngine.h"
#include "scene/basics/Error.h"
#include "scene/light/Shading.h"
#include "scene/presets/PresetFit.h"
#include "support/Places.h"
#include "widgets/view/pictures/PictureScreen.h"
#include "widgets/view/pictures/Pictures.h"

#include <QThread>

#include <chrono>
#include <cstdio>

namespace limn {
namespace {

constexpr glm::ivec2 size(900, 640);
constexpr double longestS = 20.0;

double nowS() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::vector<Preset> builtInPresets() {
  std::vector<Preset> all;
  for (const auto& entry :
       std::filesystem::directory_iterator(test::sourceFolder() / "app/core/sources/presets"))
    if (entry.path().extension() == ".json")
      all.push_back(parsePreset(readTextFile(entry.path()), entry.path().filename().string()));
  return all;
}

// A picture of a way to the exact one.
struct Stage {
  double afterS = 0.0;
  std::optional<ErrorEstimate> stated;
  std::shared_ptr<const Image> image;
};

std::vector<Stage> refine(Pictures& pictures, const Scene& scene, double turnMs) {
  pictures.want({scene}, size);
  pictures.drawCoarsely(InteractionQuality::levelCount - 1, {});
  while (!pictures.refine(turnMs)) {
  }
  const double start = nowS();
  const auto stage = [&] {
    return Stage{nowS() - start, pictures.state().sides[0].estimate, pictures.side(0).picture().image};
  };
  std::vector<Stage> stages{stage()};
  while (nowS() - start < longestS) {
    const RestTurn turn = pictures.workAtRest(true, turnMs);
    if (turn == RestTurn::nothing)
      break;
    if (turn == RestTurn::finished)
      stages.push_back(stage());
    if (turn == RestTurn::waiting)
      QThread::msleep(1);
    if (stages.size() == 1)
      stages[0].stated = pictures.state().sides[0].estimate; // small pictures tell it a little later
  }
  return stages;
}

Image exactPicture(Scene scene) {
  scene.quality.toleranceLevels = 0.01;
  scene.quality.fineness = 10.0;
  scene.quality.earlyTermination = 1.0;
  return CpuRenderer().render(scene, size);
}

void print(const std::vector<Stage>& stages, const Image& exact) {
  for (const Stage& stage : stages)
    std::printf("    %6.2f s: stated %.2f, in truth %.2f\n", stage.afterS,
                stage.stated ? stage.stated->p99_9 : -1.0, imageError(*stage.image, exact).p99_9);
  for (const double seconds : {2.0, 15.0}) {
    const auto after = std::find_if(stages.begin(), stages.end(),
                                    [&](const Stage& stage) { return stage.afterS > seconds; });
    std::printf("    after %g s: %.2f levels left\n", seconds,
                imageError(*std::prev(after)->image, exact).p99_9);
  }
}

void measure(const std::string& name, const Scene& scene) {
  const Image exact = exactPicture(scene);
  const char* const model = nameOf(scene.shading.model);
  {
    const HeadlessContext context;
    Pictures pictures(makeRayCasterEngine(), makeGlScreen());
    std::printf("%s, %s, OpenGL\n", name.c_str(), model);
    print(refine(pictures, scene, 30.0), exact);
  }
  Pictures pictures(makeCpuEngine(), makeMemoryScreen({}));
  std::printf("%s, %s, CPU engine\n", name.c_str(), model);
  print(refine(pictures, scene, 12.0), exact);
}

void measureAll(const char* path) {
  Scene scene;
  scene.volume = readVolume(path);
  scene.camera = defaultCamera(scene.volume->grid());
  scene = withPreset(scene, bestFitting(builtInPresets(), *scene.volume), true);
  for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced}) {
    scene.shading.model = model;
    measure(std::filesystem::path(path).filename().string(), scene);
  }
}

} // namespace
} // namespace limn

int main(int count, char** arguments) {
  try {
    for (int i = 1; i < count; ++i)
      limn::measureAll(arguments[i]);
  } catch (const limn::Error& error) {
    std::fprintf(stderr, "limn_refinement_time: %s\n", error.what());
    return 1;
  }
}
