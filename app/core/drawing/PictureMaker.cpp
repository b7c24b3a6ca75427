// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/PictureMaker.h"

#include "accuracy/ErrorEstimate.h"
#include "accuracy/Tolerance.h"
#include "app/core/drawing/EngineChoice.h"
#include "app/core/drawing/OnDisk.h"
#include "app/core/drawing/PathDrawing.h"
#include "cpu/CpuRenderer.h"
#include "engine/VolumeTooLarge.h"
#include "gl/HeadlessContext.h"
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/basics/Error.h"
#include "scene/effects/EffectPlan.h"
#include "scene/volume/VolumePart.h"
#include "slices/SliceRenderer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace limn {
namespace {

// Who draws, for programs and for people.
struct Drawer {
  Engine engine;
  std::string name;
  int filterBits = mostFilterBits;
};

Message levels(double number) {
  return (number == 1.0 ? Message::tr("%1 level") : Message::tr("%1 levels"))
      .arg(Message::rounded(number, 2));
}

// Where steps were found for a tolerance that the filter of this driver alone exceeds.
Message filterNote(const MadePicture& picture, int filterBits) {
  const std::optional<double>& tolerance = picture.scene.quality.toleranceLevels;
  const double added = picture.ofFilter.p99_9;
  if (!tolerance || added <= *tolerance)
    return {};
  return Message::tr(
             "The graphics card weighs voxels in %1 bits, which alone moves this picture by up to %2: "
             "it does not keep the tolerance of %3; ask for the tolerance anew (--tolerance).")
      .arg(filterBits)
      .arg(levels(added), levels(*tolerance));
}

// OpenGL has nothing to compare a grid of light with.
bool leavesLightUnmeasured(const Scene& scene, const Drawer& by) {
  return by.engine == Engine::rayCaster && hasTravellingLight(scene);
}

// When a picture tells what the filter adds to its error.
enum class TellsFilter { never, beyondTolerance, always };

TellsFilter tellsFilter(const MakingOptions& order, std::size_t index) {
  if (order.tellsFilter)
    return TellsFilter::always;
  return order.isFilm && index > 0 ? TellsFilter::never : TellsFilter::beyondTolerance;
}

// Draws a scene with the steps that keep its tolerance. `trial` draws what is only looked at on the way.
MadePicture makeWithin(const Scene& scene, const glm::ivec2& size, const DrawScene& draw,
                       const DrawScene& trial, StepControl control, const Drawer& by, TellsFilter tells) {
  // Where steps are looked for, those found heed the filter.
  const bool mayExceed = scene.quality.toleranceLevels && !needsSteps(scene);
  const bool isLit = by.engine == Engine::cpu && hasTravellingLight(scene) && !scene.quality.toleranceLevels;
  const bool measures = tells == TellsFilter::always || (tells == TellsFilter::beyondTolerance && mayExceed);
  const auto made = [&](const Scene& drawn) {
    return MadePicture{draw(drawn, size),
                       drawn,
                       by.engine,
                       by.name,
                       {},
                       false,
                       measures && !leavesLightUnmeasured(drawn, by)
                           ? errorOfFilter(drawn, size, trial, by.filterBits)
                           : ImageError(),
                       {}};
  };
  if (!needsSteps(scene)) {
    MadePicture picture = made(scene);
    if (const Message note = filterNote(picture, by.filterBits); !note.empty())
      picture.notes.push_back(note);
    if (isLit && picture.ofFilter.p99_9 > 0.0)
      picture.notes.push_back(
          Message::tr("Shadows and occlusion come along few paths of light, which is estimated to move the "
                      "picture by up to %1; --tolerance has as many followed as it needs.")
              .arg(levels(picture.ofFilter.p99_9)));
    if (leavesLightUnmeasured(scene, by))
      picture.notes.push_back(
          Message::tr("OpenGL looks shadows and occlusion up on a grid; how far they are off is "
                      "told with --engine cpu alone."));
    return picture;
  }
  const WithinTolerance found = withinTolerance(scene, size, trial, control, by.filterBits);
  MadePicture picture = made(found.scene);
  picture.steps = Message::tr("The picture is %1.").arg(describe(found));
  if (!found.holds)
    picture.notes.push_back(found.sentence);
  return picture;
}

// OpenGL was asked for by name.
void requireOpenGlMayDraw(const Scene& scene) {
  requireOpenGlMayCopy(scene);
  if (scene.quality.toleranceLevels && hasTravellingLight(scene))
    throw Error(
        Error::Kind::usage,
        Message::tr("With OpenGL no tolerance can be kept where shadows or occlusion show; use --engine "
                    "cpu or reference, or leave the tolerance out."));
  if (isPhysical(scene))
    throw Error(Error::Kind::usage,
                Message::tr("OpenGL cannot draw physical light; use --engine cpu or auto, "
                            "or another model."));
}

// Scenes one after another: each picture is handed on before the next is drawn.
struct Sitting {
  const std::vector<Scene>& scenes;
  const glm::ivec2& size;
  const TakePicture& take;
};

bool stepsSeeFunction(RayCaster& caster, const Scene& scene) {
  const DrawingFacts facts = caster.facts(scene);
  return stepSeesFunction(scene, facts.steepestPerMm, facts.plan.effects.has(Effect::preintegration));
}

bool stepsSeeFunction(CpuRenderer& renderer, const Scene& scene) {
  const bool isPreintegrated = renderer.plan(scene).effects.has(Effect::preintegration);
  return stepSeesFunction(scene, renderer.steepestPerMm(), isPreintegrated);
}

// Those that do not tell how steep the field is.
template <class Renderer>
bool stepsSeeFunction(const Renderer&, const Scene&) {
  return false;
}

void putInto(DrawnByPaths made, MadePicture& picture) {
  picture.canBeEstimated = false; // by smaller steps
  picture.paths = made.figures;
  picture.pathSeconds = made.seconds;
  picture.radiance = std::move(made.radiance);
  picture.scene.shading.physical.until = UntilPaths{made.figures.paths};
  picture.scene.quality.paths.reset();
  for (const Message& note : notesOf(made.figures, picture.scene))
    picture.notes.push_back(note);
}

// Draws pictures with one renderer; `draw` tells its effort, of which each picture has an equal part. Trials
// tell nothing: how far a picture is would begin anew with each.
template <class Renderer, class Draw>
void makeWith(Renderer& renderer, const Draw& draw, const Sitting& sitting, const MakingOptions& order,
              StepControl control, const Drawer& by) {
  const auto count = static_cast<double>(sitting.scenes.size());
  for (std::size_t i = 0; i < sitting.scenes.size(); ++i) {
    const auto place = static_cast<double>(i);
    const Effort part = partOf(order.effort, place / count, (place + 1.0) / count);
    Effort silent = part;
    silent.report = nullptr;
    MadePicture picture = makeWithin(
        sitting.scenes[i], sitting.size,
        [&](const Scene& scene, const glm::ivec2& pixels) { return draw(scene, pixels, part); },
        [&](const Scene& scene, const glm::ivec2& pixels) { return draw(scene, pixels, silent); }, control,
        by, tellsFilter(order, i));
    if (!renderer.limitation().empty())
      picture.notes.push_back(renderer.limitation());
    picture.canBeEstimated = stepsSeeFunction(renderer, picture.scene);
    sitting.take(i, std::move(picture));
  }
}

void makeWithGl(const Sitting& sitting, const MakingOptions& order, const VolumeRoom& room) {
  for (const Scene& scene : sitting.scenes)
    requireOpenGlMayDraw(scene);
  const HeadlessContext context;
  if (order.engine == Engine::slices || order.engine == Engine::slicesBackToFront) {
    SliceRenderer slices(order.engine == Engine::slices ? BlendOrder::frontToBack : BlendOrder::backToFront);
    const auto draw = [&](const Scene& scene, const glm::ivec2& pixels, const Effort&) {
      return slices.render(scene, pixels);
    };
    return makeWith(slices, draw, sitting, order, StepControl::equal,
                    {*order.engine, rendererName(), slices.filterBits()});
  }
  RayCaster caster(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, {}, room);
  const auto draw = [&](const Scene& scene, const glm::ivec2& pixels, const Effort& effort) {
    return caster.render(scene, pixels, effort);
  };
  makeWith(caster, draw, sitting, order, StepControl::local,
           {Engine::rayCaster, rendererName(), caster.filterBits()});
}

// Memory that nothing was written to before costs up to 12 µs a page of a virtual machine: a strip of 3,000
// pixels all at once would keep whoever cancels waiting.
void append(const Image& strip, Image& whole, const std::function<bool()>& isCancelled) {
  constexpr std::size_t piece = 1 << 16; // a megabyte
  for (std::size_t from = 0; from < strip.pixels.size(); from += piece) {
    if (isCancelled && isCancelled())
      throw Cancelled();
    const std::size_t to = std::min(from + piece, strip.pixels.size());
    whole.pixels.insert(whole.pixels.end(), &strip.pixels[from], strip.pixels.data() + to);
  }
}

// Any strips make the same picture; between them it is told how far it is.
Image inStrips(CpuRenderer& renderer, const Scene& scene, const glm::ivec2& size, const Effort& effort) {
  constexpr int rows = 128;
  if (size.y <= rows) {
    Image whole = renderer.draw(scene, size, {{0, 0}, size}, effort.isCancelled);
    if (effort.report)
      effort.report(1.0);
    return whole;
  }
  // Strip is put behind strip: to fill a large picture before would keep whoever cancels waiting.
  Image whole;
  whole.size = size;
  whole.pixels.reserve(static_cast<std::size_t>(size.x) * size.y);
  for (int y = 0; y < size.y; y += rows) {
    const PixelRect tile{{0, y}, {size.x, std::min(rows, size.y - y)}};
    const Image strip = renderer.draw(scene, size, tile, effort.isCancelled);
    append(strip, whole, effort.isCancelled);
    if (effort.report)
      effort.report(1.0 * (y + tile.size.y) / size.y);
  }
  return whole;
}

void makeWithCpu(const Sitting& sitting, const MakingOptions& order) {
  CpuRenderer renderer(order.effort.threads, CpuRenderer::Tolerance::stepsFirst);
  std::optional<DrawnByPaths> made; // what the picture in hand tells of its paths
  const TakePicture take = [&](std::size_t index, MadePicture picture) {
    if (made)
      putInto(std::move(*made), picture);
    made.reset();
    sitting.take(index, std::move(picture));
  };
  const auto draw = [&](const Scene& scene, const glm::ivec2& pixels, const Effort& effort) {
    if (!isPhysical(scene))
      return inStrips(renderer, scene, pixels, effort);
    made = drawnByPaths(renderer, scene, pixels, effort);
    return made->image;
  };
  makeWith(renderer, draw, {sitting.scenes, sitting.size, take}, order, StepControl::cells,
           {Engine::cpu, renderer.name()});
}

// The reference has no limits of its own to tell of.
struct ReferenceRenderer {
  std::string limitation() const { return {}; }
};

void makeWithReference(const Sitting& sitting, const MakingOptions& order) {
  const ReferenceRenderer renderer;
  const auto draw = [&](const Scene& scene, const glm::ivec2& pixels, const Effort& effort) {
    return toImage(renderReference(scene, pixels, order.effort.threads, effort.isCancelled));
  };
  makeWith(renderer, draw, sitting, order, StepControl::cells,
           {Engine::reference, "reference (double precision)"});
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
  return chosenEngine(facts).engine == Engine::cpu;
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

std::vector<Message> remarksOf(const MadePicture& picture) {
  std::vector<Message> remarks = picture.notes;
  if (!picture.steps.empty())
    remarks.insert(remarks.begin(), picture.steps);
  return remarks;
}

std::string exactnessOf(const MadePicture& picture) {
  return picture.paths ? sentenceOf(*picture.paths).english() : std::string();
}

MadePicture pictureDrawnBy(const std::function<Image(const Scene& scene, const glm::ivec2& size)>& draw,
                           const Scene& scene, const glm::ivec2& size, const std::string& name) {
  return makeWithin(scene, size, draw, draw, StepControl::cells, {Engine::cpu, name},
                    TellsFilter::beyondTolerance);
}

PictureFigures measureFigures(const Scene& scene, const glm::ivec2& size, Engine engine, int threads) {
  if (engine == Engine::reference)
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
  if (engine == Engine::cpu) {
    CpuRenderer renderer(threads, CpuRenderer::Tolerance::stepsFirst);
    return figuresWith(renderer);
  }
  const HeadlessContext context;
  RayCaster caster;
  return figuresWith(caster);
}

Engine engineFor(const Scene& scene, const EngineMemory& memory) {
  try {
    requireInMemory(*scene.volume);
    requireLightOfShaders(scene);
    return hasTravellingLight(scene) || processorIsFaster(scene, memory) ? Engine::cpu : Engine::rayCaster;
  } catch (const Error& error) {
    if (error.kind() != Error::Kind::openGl)
      throw;
    return Engine::cpu;
  }
}

void makeEach(const std::vector<Scene>& scenes, const glm::ivec2& size, const MakingOptions& order,
              const TakePicture& take) {
  std::size_t taken = 0;
  const TakePicture counted = [&](std::size_t index, MadePicture picture) {
    take(index, std::move(picture));
    ++taken;
  };
  const Sitting sitting{scenes, size, counted};
  if (order.engine == Engine::reference)
    return makeWithReference(sitting, order);
  if (order.engine == Engine::cpu)
    return makeWithCpu(sitting, order);
  if (order.engine)
    return makeWithGl(sitting, order, {order.textureMb, true});
  // Physical light is always drawn by the processor, and shadows are followed by it alone: where nobody
  // chose, there is nothing to excuse.
  if (std::ranges::any_of(scenes,
                          [](const Scene& scene) { return isPhysical(scene) || hasTravellingLight(scene); }))
    return makeWithCpu(sitting, order);
  Message problem;
  try {
    for (const Scene& scene : scenes) {
      requireInMemory(*scene.volume);
      requireLightOfShaders(scene);
    }
    if (!processorIsFaster(scenes.front(), order.memory))
      return makeWithGl(sitting, order, {order.textureMb, false});
  } catch (const Error& error) {
    if (error.kind() != Error::Kind::openGl || taken > 0)
      throw;
    problem = error.sentence();
  }
  const TakePicture excused = [&](std::size_t index, MadePicture picture) {
    if (!problem.empty() && index == 0)
      picture.notes.push_back(Message::tr("%1 The CPU engine drew the picture instead.").arg(problem));
    take(index, std::move(picture));
  };
  makeWithCpu({scenes, size, excused}, order);
}

std::vector<MadePicture> makePictures(const std::vector<Scene>& scenes, const glm::ivec2& size,
                                      std::optional<Engine> engine, int threads, double textureMb,
                                      const EngineMemory& memory) {
  std::vector<MadePicture> pictures;
  makeEach(scenes, size, {engine, textureMb, memory, {threads, {}, {}}},
           [&](std::size_t, MadePicture picture) { pictures.push_back(std::move(picture)); });
  return pictures;
}

std::vector<int> countSamples(const Scene& scene, const glm::ivec2& size, Engine engine, int threads) {
  if (engine == Engine::slices || engine == Engine::slicesBackToFront)
    throw Error(Error::Kind::usage,
                "Slices take the same samples in every pixel; count those of --engine gl or reference.");
  if (engine == Engine::cpu)
    throw Error(Error::Kind::usage,
                "The CPU engine takes the reference's samples and does not count them; count "
                "those of --engine reference.");
  if (engine == Engine::reference)
    return renderReference(scene, size, threads).samples;
  const HeadlessContext context;
  return RayCaster().sampleCounts(scene, size);
}

DrawPrecisely preciselyBy(int threads, std::function<bool()> isCancelled) {
  return [threads, isCancelled = std::move(isCancelled)](const Scene& scene, const glm::ivec2& size,
                                                         const std::vector<std::uint8_t>& wanted,
                                                         PrecisePixels& pixels) {
    ReferencePicture picture{size, std::move(pixels), std::vector<int>(wanted.size(), 0)};
    redrawReference(picture, scene, wanted, threads, isCancelled);
    pixels = std::move(picture.pixels);
  };
}

// What was asked for is brought down by as much as was found more.
Message noteBeyondTolerance(const Scene& asked, const ErrorByChance& found) {
  const std::optional<double>& tolerance = asked.quality.toleranceLevels;
  if (!tolerance || found.levels <= *tolerance)
    return {};
  const double less = std::max(0.01, std::floor(100.0 * *tolerance * *tolerance / found.levels) / 100.0);
  return Message::tr("Single pixels lie farther off than the tolerance of %1, which is kept by an estimate; "
                     "ask for less, such as --tolerance %2, for a picture that keeps it in these, too.")
      .arg(levels(*tolerance), Message::rounded(less, 2));
}

std::optional<ErrorByChance> chanceOf(const Scene& scene, const Image& picture, const Effort& effort) {
  Scene whole = scene;
  whole.volume = wholeOf(scene.volume);
  // The reference follows light that travels for each sample: that takes hours.
  if (staysOnDisk(whole) || hasTravellingLight(whole))
    return std::nullopt;
  return errorByChance(whole, picture, preciselyBy(effort.threads, effort.isCancelled));
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
