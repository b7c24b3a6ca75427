// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/ErrorProbe.h"

#include "accuracy/Tolerance.h"
#include "engine/DrawingEngine.h"
#include "scene/basics/Error.h"
#include "scene/effects/EffectPlan.h"
#include "widgets/view/pictures/InteractionQuality.h"
#include "widgets/view/pictures/RestWork.h"

#include <cmath>

namespace limn {
namespace {

// What was estimated of one scene tells something of the other.
bool areAkin(const Scene& one, const Scene& other) {
  return one.volume == other.volume && one.projection == other.projection &&
         one.shading.model == other.shading.model && hasTravellingLight(one) == hasTravellingLight(other);
}

} // namespace

void ErrorProbe::want(const std::vector<Scene>& shown, const glm::ivec2& size) {
  m_size = smallerSize(size, longest);
  m_sides.resize(shown.size());
  for (std::size_t i = 0; i < shown.size(); ++i) {
    Side& side = m_sides[i];
    if (!areAkin(shown[i], side.scene))
      side.measured.reset();
    side.isDue = side.isDue || shown[i] != side.scene;
    side.scene = shown[i];
  }
}

bool ErrorProbe::step(DrawingEngine& engine) {
  for (Side& side : m_sides) {
    if (!side.isDue)
      continue;
    side.isDue = false;
    // What a grid of light is off by takes seconds to tell, and steps alone would tell too little: at rest.
    // Of paths they tell nothing.
    if (hasTravellingLight(side.scene) || isPhysical(side.scene))
      continue;
    const double step = side.scene.quality.stepVoxels;
    bool isReady = true;
    for (const double part : {0.5, 0.25})
      isReady = isReady && engine.facts(withStep(side.scene, part * step)).isReady;
    try {
      if (isReady)
        side.measured = measure(engine, side.scene);
    } catch (const Cancelled&) {
      side.isDue = true;
      throw;
    }
    return true;
  }
  return false;
}

ErrorProbe::Measured ErrorProbe::measure(DrawingEngine& engine, const Scene& scene) {
  const double step = scene.quality.stepVoxels;
  m_sheet->resize(m_size);
  const Image shown = draw(engine, withStep(scene, step));
  const Image half = draw(engine, withStep(scene, step / 2.0));
  const Image quarter = draw(engine, withStep(scene, step / 4.0));
  const ImageError first = imageError(half, shown);
  const ImageError second = imageError(quarter, half);
  return {step, errorBeforeHalvings(first, second), errorOfEarlyEnds(shown, scene), ofFilter(engine, scene)};
}

ImageError ErrorProbe::ofFilter(DrawingEngine& engine, const Scene& scene) {
  return errorOfFilter(
      scene, m_size, [&](const Scene& drawn, const glm::ivec2&) { return draw(engine, drawn); },
      engine.facts(scene).filterBits, false);
}

Image ErrorProbe::draw(DrawingEngine& engine, const Scene& scene) {
  m_sheet->draw(engine, scene, {{0, 0}, m_size});
  return m_sheet->read();
}

std::optional<ErrorEstimate> ErrorProbe::estimate(int side, double stepVoxels) const {
  if (side >= static_cast<int>(m_sides.size()) || !m_sides[static_cast<std::size_t>(side)].measured)
    return std::nullopt;
  const Measured& measured = *m_sides[static_cast<std::size_t>(side)].measured;
  const double scale = std::pow(stepVoxels / measured.stepVoxels, measured.steps.order);
  ErrorEstimate steps = measured.steps;
  steps.p99_9 *= scale;
  steps.mean *= scale;
  return withFilter(withEarlyEnds(steps, measured.earlyEnds), measured.filter);
}

} // namespace limn
