// SPDX-License-Identifier: GPL-3.0-or-later
#include <epoxy/gl.h> // before any OpenGL header of Qt

#include "widgets/view/ErrorProbe.h"

#include "scene/LocalSteps.h"
#include "widgets/view/RestWork.h"

#include <cmath>

namespace limn {
namespace {

// What was estimated of one scene tells something of the other.
bool areAkin(const Scene& one, const Scene& other) {
  return one.volume == other.volume && one.projection == other.projection &&
         one.shading.model == other.shading.model;
}

Scene atStep(Scene scene, double stepVoxels) {
  scene.quality = withSteps(scene.quality, stepVoxels);
  return scene;
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

bool ErrorProbe::step(RayCaster& caster) {
  for (Side& side : m_sides) {
    if (!side.isDue)
      continue;
    side.isDue = false;
    const double step = side.scene.quality.stepVoxels;
    bool isReady = true;
    for (const double part : {0.5, 0.25})
      isReady = isReady && caster.isReady(atStep(side.scene, part * step));
    if (isReady)
      side.measured = measure(caster, side.scene);
    return true;
  }
  return false;
}

ErrorProbe::Measured ErrorProbe::measure(RayCaster& caster, const Scene& scene) {
  const double step = scene.quality.stepVoxels;
  m_target.resize(m_size);
  const Image shown = draw(caster, scene, step);
  const Image half = draw(caster, scene, step / 2.0);
  const Image quarter = draw(caster, scene, step / 4.0);
  const ImageError first = imageError(half, shown);
  const ImageError second = imageError(quarter, half);
  return {step, errorBeforeHalvings(first, second), errorOfEarlyEnds(shown, scene)};
}

Image ErrorProbe::draw(RayCaster& caster, Scene scene, double stepVoxels) {
  scene.quality = withSteps(scene.quality, stepVoxels);
  m_target.bind();
  caster.draw(scene, m_size, {{0, 0}, m_size});
  return m_target.read();
}

std::optional<ErrorEstimate> ErrorProbe::estimate(int side, double stepVoxels) const {
  if (side >= static_cast<int>(m_sides.size()) || !m_sides[static_cast<std::size_t>(side)].measured)
    return std::nullopt;
  const Measured& measured = *m_sides[static_cast<std::size_t>(side)].measured;
  const double scale = std::pow(stepVoxels / measured.stepVoxels, measured.steps.order);
  ErrorEstimate steps = measured.steps;
  steps.p99_9 *= scale;
  steps.mean *= scale;
  return withEarlyEnds(steps, measured.earlyEnds);
}

} // namespace limn
