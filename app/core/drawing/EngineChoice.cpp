// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/EngineChoice.h"

#include "app/core/drawing/ProcessCost.h"
#include "cpu/CpuEngine.h"
#include "cpu/CpuRenderer.h"
#include "gl/HeadlessContext.h"
#include "gl/PictureTarget.h"
#include "raycaster/RayCasterEngine.h"
#include "scene/effects/EffectPlan.h"
#include "scene/steps/LocalSteps.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <epoxy/gl.h>
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

// Drivers that compute on the processor what a graphics card would.
bool isSoftware(const std::string& renderer) {
  constexpr std::array names{"llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SWR"};
  return std::ranges::any_of(names,
                             [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

Message trialSentence(const EngineTimes& times) {
  return Message::
      tr("In a trial on this computer a small picture took %1 ms with OpenGL and %2 ms with the processor.")
          .arg(Message::fixed(times.openGlMs, 1))
          .arg(Message::fixed(times.processorMs, 1));
}

} // namespace

EngineTrial tryEngines(const Scene& scene, const std::function<bool()>& isCancelled) {
  Scene drawn = scene;
  drawn.quality = withSteps(scene.quality, std::max(scene.quality.stepVoxels, smallestStepVoxels));
  // What one of them alone can draw says nothing of the other.
  if (isPhysical(drawn))
    drawn.shading.model = ShadingModel::classic;
  drawn.shading.shadow = {};
  drawn.shading.occlusion = {};
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

std::string machineWith(const std::string& renderer) {
  return renderer + "; " + machineName() + "; " + CpuRenderer().name();
}

EngineChoice chosenEngine(const EngineFacts& facts) {
  if (!facts.problem.empty())
    return {Engine::cpu, false, facts.problem};
  if (facts.setting)
    return {*facts.setting, false, Message::tr("Chosen in the settings.")};
  if (facts.times)
    return {facts.times->processorMs < facts.times->openGlMs ? Engine::cpu : Engine::rayCaster, false,
            trialSentence(*facts.times)};
  if (isSoftware(facts.renderer))
    return {Engine::cpu, true,
            Message::tr(
                "The graphics driver has no card and draws on the processor itself, where the CPU engine is "
                "likely to be faster.")};
  return {Engine::rayCaster, true, Message::tr("A graphics card is likely to be faster than the processor.")};
}

} // namespace limn
