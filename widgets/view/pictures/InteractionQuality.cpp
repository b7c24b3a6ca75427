// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/pictures/InteractionQuality.h"

#include "scene/effects/EffectPlan.h"
#include "scene/steps/LocalSteps.h"

#include <array>
#include <cassert>
#include <cmath>

namespace limn {
namespace {

constexpr std::array<QualityLevel, InteractionQuality::levelCount> qualityLevels{{{1.0, 1.0},
                                                                                  {1.0, 2.0},
                                                                                  {0.75, 2.0},
                                                                                  {0.5, 2.0},
                                                                                  {0.375, 2.0},
                                                                                  {0.3125, 2.0},
                                                                                  {0.25, 3.0},
                                                                                  {0.1875, 4.0},
                                                                                  {0.125, 4.0}}};

// A finer level must promise this part of the target, or two levels would take turns.
constexpr double marginToFiner = 0.75;

} // namespace

QualityLevel InteractionQuality::levelAt(int index) {
  assert(index >= 0 && index < levelCount);
  return qualityLevels[index];
}

double InteractionQuality::relativeCost(int index) {
  const QualityLevel& level = qualityLevels[index];
  // A renderer that skips empty space gains less than half from twice the step: measured exponents lie
  // between 0.76 (opaque) and 0.9 (semi-transparent).
  return level.imageScale * level.imageScale / std::pow(level.stepFactor, 0.8);
}

int InteractionQuality::levelFor(double pixels) const {
  if (!m_msPerPixel)
    return levelCount - 1;
  for (int index = 0; index < levelCount; ++index) {
    const double allowed = index < m_lastLevel ? marginToFiner * m_targetMs : m_targetMs;
    if (*m_msPerPixel * pixels * relativeCost(index) <= allowed)
      return index;
  }
  return levelCount - 1;
}

void InteractionQuality::measured(int level, double pixels, double ms) {
  assert(level >= 0 && level < levelCount && pixels > 0.0);
  const double perPixel = ms / (pixels * relativeCost(level));
  m_msPerPixel = m_msPerPixel ? 0.5 * (*m_msPerPixel + perPixel) : perPixel;
  m_lastLevel = level;
}

glm::ivec2 sizeAt(const QualityLevel& level, const glm::ivec2& size) {
  return glm::max(glm::ivec2(1), glm::ivec2(glm::round(glm::dvec2(size) * level.imageScale)));
}

Scene withStep(Scene scene, double stepVoxels) {
  scene.quality = withSteps(scene.quality, stepVoxels);
  return scene;
}

Scene withQualityLevel(const Scene& scene, const QualityLevel& level) {
  Scene drawn = withStep(scene, level.stepFactor * scene.quality.stepVoxels);
  if (level != QualityLevel{} && hasTravellingLight(scene))
    drawn.quality.light = LightDetail::moving;
  if (isPhysical(scene))
    drawn.quality.paths = 1;
  return drawn;
}

} // namespace limn
