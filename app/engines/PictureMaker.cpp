// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/engines/PictureMaker.h"

#include "accuracy/Tolerance.h"
#include "app/engines/EngineTrial.h"
#include "cpu/CpuRenderer.h"
#include "gl/HeadlessContext.h"
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/basics/Error.h"
#include "slices/SliceRenderer.h"

#include <algorithm>
#include <cassert>

namespace limn {
namespace {

// Who draws, for programs and for people.
struct Drawer {
  PictureEngine engine;
  std::string name;
};

// Draws a scene with the steps that keep its tolerance.
MadePicture makeWithin(const Scene& scene, const glm::ivec2& size, const DrawScene& draw, StepControl control,
                       const Drawer& by) {
  if (!needsSteps(scene))
    return {draw(scene, size), scene, by.engine, by.name, {}};
  const WithinTolerance found = withinTolerance(scene, size, draw, control);
  MadePicture picture{draw(found.scene, size), found.scene, by.engine, by.name, {}};
  picture.notes.push_back(Message::tr("The picture is %1.").arg(describe(found)));
  if (!found.holds)
    picture.notes.push_back(found.sentence);
  return picture;
}

template <class Renderer>
std::vector<MadePicture> makeWith(Renderer& renderer, const std::vector<Scene>& scenes,
                                  const glm::ivec2& size, StepControl control, const Drawer& by) {
  std::vector<MadePicture> pictures;
  const DrawScene draw = [&](const Scene& scene, const glm::ivec2& pixels) {
    return renderer.render(scene, pixels);
  };
  for (const Scene& scene : scenes) {
    MadePicture picture = makeWithin(scene, size, draw, control, by);
    if (!renderer.limitation().empty())
      picture.notes.push_back(renderer.limitation());
    pictures.push_back(std::move(picture));
  }
  return pictures;
}

std::vector<MadePicture> makeWithGl(const std::vector<Scene>& scenes, const glm::ivec2& size,
                                    PictureEngine engine, const VolumeRoom& room) {
  const HeadlessContext context;
  if (engine == PictureEngine::slices || engine == PictureEngine::slicesBackToFront) {
    SliceRenderer slices(engine == PictureEngine::slices ? BlendOrder::frontToBack : BlendOrder::backToFront);
    return makeWith(slices, scenes, size, StepControl::equal, {engine, rendererName()});
  }
  RayCaster caster(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, {}, room);
  return makeWith(caster, scenes, size, StepControl::local, {PictureEngine::gl, rendererName()});
}

std::vector<MadePicture> makeWithCpu(const std::vector<Scene>& scenes, const glm::ivec2& size, int threads) {
  CpuRenderer renderer(threads);
  return makeWith(renderer, scenes, size, StepControl::local, {PictureEngine::cpu, renderer.name()});
}

std::vector<MadePicture> makeWithReference(const std::vector<Scene>& scenes, const glm::ivec2& size,
                                           int threads) {
  std::vector<MadePicture> pictures;
  const DrawScene draw = [threads](const Scene& scene, const glm::ivec2& pixels) {
    return toImage(renderReference(scene, pixels, threads));
  };
  for (const Scene& scene : scenes)
    pictures.push_back(makeWithin(scene, size, draw, StepControl::local,
                                  {PictureEngine::reference, "reference (double precision)"}));
  return pictures;
}

// The context of the question is gone before a picture makes its own.
std::string nameOfDriver() {
  const HeadlessContext context;
  return rendererName();
}

bool processorIsFaster(const Scene& scene, const EngineMemory& memory) {
  EngineFacts facts;
  facts.renderer = nameOfDriver();
  const std::string machine = machineWith(facts.renderer);
  if (memory.recall)
    facts.times = memory.recall(machine);
  if (!facts.times) {
    facts.times = tryEngines(scene, {}).times;
    if (memory.remember)
      memory.remember(machine, *facts.times);
  }
  return chosenEngine(facts).isProcessor;
}

// Draws a scene whole, or without limits to its light.
using Draw = std::function<Image(const Scene& scene, Limiting limiting)>;

PictureFigures figuresBy(const Draw& draw, const Scene& scene) {
  const TissueScenes tissue = tissueScenes(scene);
  PictureFigures figures;
  figures.contrast = contrastOf(draw(scene, Limiting::clampOrKnee));
  figures.overflow = overflowOf(draw(scene, Limiting::none));
  figures.visibleShare =
      visibleShare(draw(tissue.weights, Limiting::clampOrKnee), draw(tissue.surface, Limiting::clampOrKnee));
  return figures;
}

} // namespace

PictureFigures measureFigures(const Scene& scene, const glm::ivec2& size, PictureEngine engine, int threads) {
  if (engine == PictureEngine::reference)
    return figuresBy(
        [&](const Scene& drawn, Limiting limiting) {
          return toImage(renderReference(drawn, size, threads, {}, limiting));
        },
        scene);
  const auto figuresWith = [&](auto& renderer) {
    return figuresBy(
        [&](const Scene& drawn, Limiting limiting) {
          return limiting == Limiting::none ? renderer.renderUnlimited(drawn, size)
                                            : renderer.render(drawn, size);
        },
        scene);
  };
  if (engine == PictureEngine::cpu) {
    CpuRenderer renderer(threads);
    return figuresWith(renderer);
  }
  const HeadlessContext context;
  RayCaster caster;
  return figuresWith(caster);
}

std::vector<MadePicture> makePictures(const std::vector<Scene>& scenes, const glm::ivec2& size,
                                      PictureEngine engine, int threads, double textureMb,
                                      const EngineMemory& memory) {
  if (engine == PictureEngine::reference)
    return makeWithReference(scenes, size, threads);
  if (engine == PictureEngine::cpu)
    return makeWithCpu(scenes, size, threads);
  if (engine != PictureEngine::automatic)
    return makeWithGl(scenes, size, engine, {textureMb, true});
  try {
    if (!processorIsFaster(scenes.front(), memory))
      return makeWithGl(scenes, size, engine, {textureMb, false});
  } catch (const Error& error) {
    if (error.kind() != Error::Kind::openGl)
      throw;
    std::vector<MadePicture> pictures = makeWithCpu(scenes, size, threads);
    pictures.front().notes.push_back(
        Message::tr("%1 The CPU engine drew the picture instead.").arg(error.sentence()));
    return pictures;
  }
  return makeWithCpu(scenes, size, threads);
}

std::vector<int> countSamples(const Scene& scene, const glm::ivec2& size, PictureEngine engine, int threads) {
  if (engine == PictureEngine::slices || engine == PictureEngine::slicesBackToFront)
    throw Error(Error::Kind::usage,
                "Slices take the same samples in every pixel; count those of --engine gl or reference.");
  if (engine == PictureEngine::cpu)
    throw Error(Error::Kind::usage,
                "The CPU engine takes the reference's samples and does not count them; count "
                "those of --engine reference.");
  if (engine == PictureEngine::reference)
    return renderReference(scene, size, threads).samples;
  const HeadlessContext context;
  return RayCaster().sampleCounts(scene, size);
}

Image sideBySide(const Image& left, const Image& right) {
  assert(left.size.y == right.size.y);
  Image joined({left.size.x + right.size.x, left.size.y});
  for (int y = 0; y < left.size.y; ++y) {
    std::copy_n(&left.at(0, y), left.size.x, &joined.at(0, y));
    std::copy_n(&right.at(0, y), right.size.x, &joined.at(left.size.x, y));
  }
  return joined;
}

} // namespace limn
