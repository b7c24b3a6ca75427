// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/EngineTrial.h"

#include "cpu/CpuEngine.h"
#include "gl/HeadlessContext.h"
#include "gl/PictureTarget.h"
#include "raycaster/RayCasterEngine.h"
#include "scene/basics/Error.h"
#include "scene/steps/LocalSteps.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <chrono>
#include <limits>

namespace limn {
namespace {

constexpr glm::ivec2 trialSize{192, 144};
constexpr int rounds = 3;
constexpr double smallestStepVoxels = 0.5; // smaller ones take long and divide the same rays

template <class Work>
void keepShortest(double& shortestMs, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - start;
  shortestMs = std::min(shortestMs, ms.count());
}

} // namespace

EngineTrial tryEngines(const Scene& scene, const std::function<bool()>& isCancelled) {
  Scene drawn = scene;
  drawn.quality = withSteps(scene.quality, std::max(scene.quality.stepVoxels, smallestStepVoxels));
  const PixelRect whole{{0, 0}, trialSize};
  const HeadlessContext context;
  const std::unique_ptr<DrawingEngine> openGl = makeRayCasterEngine();
  const std::unique_ptr<DrawingEngine> processor = makeCpuEngine();
  PictureTarget target;
  target.resize(trialSize);
  const auto drawWithOpenGl = [&] {
    target.bind();
    openGl->draw(drawn, trialSize, whole, {});
    glFinish();
  };
  const auto drawWithProcessor = [&] { processor->draw(drawn, trialSize, whole, isCancelled); };
  const auto goOn = [&] {
    if (isCancelled && isCancelled())
      throw Cancelled();
  };
  drawWithProcessor();
  goOn();
  drawWithOpenGl();
  constexpr double forever = std::numeric_limits<double>::infinity();
  EngineTrial trial{rendererName(), {forever, forever}};
  for (int round = 0; round < rounds; ++round) {
    goOn();
    keepShortest(trial.times.openGlMs, drawWithOpenGl);
    keepShortest(trial.times.processorMs, drawWithProcessor);
  }
  return trial;
}

} // namespace limn
