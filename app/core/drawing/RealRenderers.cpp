// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/drawing/RealRenderers.h"

#include "accuracy/Tolerance.h"
#include "app/core/drawing/OnDisk.h"
#include "app/core/drawing/PictureMaker.h"
#include "app/core/drawing/ProcessCost.h"
#include "cpu/CpuEngine.h"
#include "gl/HeadlessContext.h"
#include "gl/PictureTarget.h"
#include "raycaster/RayCaster.h"
#include "reference/ReferenceIntegrator.h"
#include "scene/basics/Error.h"
#include "scene/effects/EffectPlan.h"
#include "slices/SliceRenderer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

namespace limn {
namespace {

Decisions decisionsFor(const OperatingPoint& point) {
  Decisions decisions;
  if (point.gradients == GradientSource::precomputed)
    decisions.gradients = GradientFormat::halves;
  return decisions;
}

} // namespace

struct RealRenderers::Parts {
  std::optional<HeadlessContext> context; ///< absent: the processor casts the rays
  std::unique_ptr<DrawingEngine> processor;
  int threads = 0;
  std::function<bool()> isCancelled;
  std::optional<RayCaster> rays;
  std::optional<RayCaster> raysWithStoredGradients;
  std::optional<SliceRenderer> slices;
  std::optional<FloatTarget> target;
  glm::ivec2 targetSize{0};
  std::optional<Image> picture; ///< absent: still in the target
  Scene toleranceScene;         ///< whose steps were found
  std::map<double, Scene> withinTolerances;

  void draw(const Scene& scene, const OperatingPoint& point, const glm::ivec2& size);
  void drawRays(const Scene& scene, const OperatingPoint& point, const glm::ivec2& size);
  Image byProcessor(const Scene& scene, const glm::ivec2& size);
  int filterBits();
  Image whole(const Scene& scene, const glm::ivec2& size);
  Scene withSteps(const Scene& scene, const OperatingPoint& point, const glm::ivec2& size);
  double peakMb(const Scene& scene, const OperatingPoint& point, const glm::ivec2& size);
  void forget();
};

void RealRenderers::Parts::draw(const Scene& scene, const OperatingPoint& point, const glm::ivec2& size) {
  const Scene drawn = point.toleranceLevels ? withSteps(scene, point, size) : atPoint(scene, point);
  picture.reset();
  switch (point.engine) {
  case Engine::rayCaster:
  case Engine::cpu:
    return drawRays(drawn, point, size);
  case Engine::slices:
  case Engine::slicesBackToFront:
    if (!slices)
      slices.emplace();
    picture = slices->render(drawn, size);
    return;
  case Engine::reference:
    picture = toImage(renderReference(drawn, size, threads, isCancelled));
    return;
  }
}

Image RealRenderers::Parts::byProcessor(const Scene& scene, const glm::ivec2& size) {
  if (!processor)
    processor = makeCpuEngine();
  return *processor->draw(scene, size, {{0, 0}, size}, isCancelled);
}

void RealRenderers::Parts::drawRays(const Scene& scene, const OperatingPoint& point, const glm::ivec2& size) {
  if (!context) {
    picture = byProcessor(scene, size);
    return;
  }
  if (!target || targetSize != size) {
    target.reset();
    target.emplace(size);
    targetSize = size;
  }
  const bool isStored = point.gradients == GradientSource::precomputed;
  std::optional<RayCaster>& caster = isStored ? raysWithStoredGradients : rays;
  if (!caster)
    caster.emplace(RayCaster::EmptySpace::skipped, RayCaster::Programs::specialised, decisionsFor(point));
  // In pieces that no watchdog takes for a hang.
  constexpr int tileSize = 256;
  for (int y = 0; y < size.y; y += tileSize)
    for (int x = 0; x < size.x; x += tileSize) {
      caster->draw(scene, size, {{x, y}, glm::min(glm::ivec2(tileSize), size - glm::ivec2(x, y))});
      glFlush();
    }
  glFinish();
}

int RealRenderers::Parts::filterBits() {
  if (!context)
    return mostFilterBits;
  if (!rays)
    rays.emplace();
  return rays->filterBits();
}

// A picture beside those that are measured.
Image RealRenderers::Parts::whole(const Scene& scene, const glm::ivec2& size) {
  if (context) {
    if (!rays)
      rays.emplace();
    return rays->render(scene, size);
  }
  return byProcessor(scene, size);
}

// The steps that keep the point's tolerance, found when the scene is first drawn at it.
Scene RealRenderers::Parts::withSteps(const Scene& scene, const OperatingPoint& point,
                                      const glm::ivec2& size) {
  if (scene != toleranceScene) {
    withinTolerances.clear();
    toleranceScene = scene;
  }
  auto known = withinTolerances.find(*point.toleranceLevels);
  if (known == withinTolerances.end()) {
    // What goes cell by cell in double does so as far in floats, and sooner.
    const bool isByCells = !context || point.engine == Engine::reference;
    const auto draw = [this, isByCells](const Scene& tried, const glm::ivec2& pixels) {
      return isByCells ? byProcessor(tried, pixels) : whole(tried, pixels);
    };
    const WithinTolerance found = withinTolerance(atPoint(scene, point), size, draw,
                                                  isByCells ? StepControl::cells : StepControl::local,
                                                  isByCells ? mostFilterBits : filterBits());
    known = withinTolerances.emplace(*point.toleranceLevels, found.scene).first;
  }
  return known->second;
}

void RealRenderers::Parts::forget() {
  picture.reset();
  rays.reset();
  raysWithStoredGradients.reset();
  slices.reset();
  target.reset();
  processor.reset();
  if (context)
    glFinish();
}

double RealRenderers::Parts::peakMb(const Scene& scene, const OperatingPoint& point, const glm::ivec2& size) {
  // The search for steps is no part of drawing with them.
  if (point.toleranceLevels)
    withSteps(scene, point, size);
  forget();
  forgetPeak();
  const double before = residentMb();
  draw(scene, point, size);
  return peakResidentMb() - before;
}

Engine raysAtHand(const Scene& scene) {
  if (staysOnDisk(scene) || hasTravellingLight(scene) || isPhysical(scene))
    return Engine::cpu;
  try {
    const HeadlessContext context;
    return Engine::rayCaster;
  } catch (const Error&) {
    return Engine::cpu;
  }
}

RealRenderers::RealRenderers(int threads, std::function<bool()> isCancelled, Engine rays)
    : m_parts(std::make_unique<Parts>()) {
  if (rays == Engine::rayCaster)
    m_parts->context.emplace();
  m_parts->threads = threads;
  m_parts->isCancelled = std::move(isCancelled);
}
RealRenderers::~RealRenderers() = default;

bool RealRenderers::canDraw(const OperatingPoint& point) const {
  return m_parts->context || point.engine == Engine::reference ||
         (point.engine == Engine::rayCaster && point.gradients != GradientSource::precomputed);
}

std::string RealRenderers::name() const {
  return m_parts->context ? rendererName() : makeCpuEngine()->name();
}

SweepRenderers RealRenderers::forSweep() {
  Parts& parts = *m_parts;
  return {[&parts](const Scene& scene, const OperatingPoint& point, const glm::ivec2& size) {
            parts.draw(scene, point, size);
          },
          [&parts] { return parts.picture ? *parts.picture : readBack(parts.targetSize); },
          [&parts](const Scene& scene, const OperatingPoint& point, const glm::ivec2& size) {
            return parts.peakMb(scene, point, size);
          }};
}

DrawPrecisely RealRenderers::precisely() {
  return preciselyBy(m_parts->threads, m_parts->isCancelled);
}

int RealRenderers::filterBits() {
  return m_parts->filterBits();
}

StepControl RealRenderers::control() const {
  return m_parts->context ? StepControl::local : StepControl::cells;
}

Image RealRenderers::render(const Scene& scene, const glm::ivec2& size) {
  return m_parts->whole(scene, size);
}

AccuracyReport reportOn(const std::string& name, const std::string& renderer, const Scene& scene,
                        const glm::ivec2& size) {
  AccuracyReport report;
  report.scene = name;
  report.renderer = renderer;
  report.machine = machineName();
  report.size = size;
  report.smallestSpacingMm = smallestSpacingMm(scene.volume->grid());
  return report;
}

AccuracyReport measureAccuracy(const std::string& name, const Scene& scene, const glm::ivec2& size,
                               const std::vector<OperatingPoint>& points, const ConvergedPicture& converged,
                               RealRenderers& renderers, const ReportProgress& progress) {
  AccuracyReport report = reportOn(name, renderers.name(), scene, size);
  report.reference = converged.facts;
  std::vector<OperatingPoint> drawable;
  std::ranges::copy_if(points, std::back_inserter(drawable),
                       [&](const OperatingPoint& point) { return renderers.canDraw(point); });
  measurePoints(report, scene, drawable, converged.pixels, renderers.forSweep(), progress);
  return report;
}

} // namespace limn
