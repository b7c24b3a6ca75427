// SPDX-License-Identifier: GPL-3.0-or-later
// Milliseconds per frame of the GLSL ray caster, and of measuring gradients. Held fixed: 512², default
// camera, Blinn-Phong headlight, early termination at its default. One warm-up, then seven frames, each
// finished by reading it back; median, least and most of the wall time, and the mean time of all cores. Not
// part of the test command.
#include "gl/HeadlessContext.h"
#include "raycaster/RayCaster.h"
#include "scene/Gradient.h"
#include "scene/Phantom.h"
#include "support/Heads.h"
#include "support/TestData.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>

namespace limn {
namespace {

template <class Work>
double millisecondsOf(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

template <class Work>
void report(const char* what, const Work& work) {
  work();
  std::vector<double> times;
  const std::clock_t before = std::clock();
  for (int i = 0; i < 7; ++i)
    times.push_back(millisecondsOf(work));
  std::sort(times.begin(), times.end());
  const double cores = 1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC / 7.0;
  std::printf("%-44s %8.1f ms (%.1f .. %.1f), %.1f ms of cores\n", what, times[3], times.front(),
              times.back(), cores);
}

// A control point is moved and the picture drawn, against the same picture drawn again.
void reportEdit(RayCaster& caster, const std::shared_ptr<const Volume>& volume) {
  Scene scene = test::headScene(volume, ShadingModel::classic);
  scene.quality = {.stepVoxels = 1.0};
  report("64 x 64, nothing changed", [&] { caster.render(scene, {64, 64}); });
  double value = 250.0;
  report("64 x 64, a control point moved", [&] {
    scene.transferFunction = withPointMoved(scene.transferFunction, 5, value += 1.0, 0.3);
    caster.render(scene, {64, 64});
  });
}

void reportScenes(RayCaster& caster, const std::shared_ptr<const Volume>& volume) {
  for (const bool bone : {true, false})
    for (const ShadingModel model : {ShadingModel::classic, ShadingModel::enhanced})
      for (const double step : {1.0, 0.5}) {
        Scene scene = test::headScene(volume, model);
        scene.quality = {.stepVoxels = step};
        if (bone)
          scene.transferFunction = test::boneOnly();
        char what[80];
        std::snprintf(what, sizeof(what), "%s, %s, step %.1f", bone ? "bone" : "skin-muscle-bone",
                      model == ShadingModel::classic ? "classic" : "enhanced", step);
        report(what, [&] { caster.render(scene, {512, 512}); });
      }
}

} // namespace
} // namespace limn

int main() {
  using namespace limn;
  const HeadlessContext context;
  std::printf("%s\n", rendererName().c_str());
  const bool isReal = std::filesystem::exists(test::sharedFolder() / test::ctHeadFile);
  const auto volume = isReal ? test::ctHead() : phantomVolume({.spacingMm = 1.0});
  const glm::ivec3 dims = volume->grid().dims;
  std::printf("%s, %d x %d x %d, 512 x 512\n", isReal ? "CT head" : "phantom", dims.x, dims.y, dims.z);
  report("largest gradient", [&] { largestGradient(*volume); });
  report("99.5th percentile of the gradient", [&] { gradientPercentile(*volume, 99.5); });
  report("first frame (upload, gradients, shader)", [&] {
    RayCaster fresh;
    fresh.render(test::headScene(volume, ShadingModel::classic), {64, 64});
  });
  RayCaster caster;
  reportEdit(caster, volume);
  reportScenes(caster, volume);
}
