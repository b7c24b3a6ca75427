// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/effects/Neighbours.h"

#include <algorithm>

namespace limn {
namespace {

double offZero(double value) {
  return value > 0.0 ? value : 1.0;
}

CoefficientRange widened(CoefficientRange range, double highest) {
  if (range.atFlat != range.atBoundary)
    return range;
  return range.atBoundary < highest
             ? CoefficientRange{range.atFlat, std::min(highest, range.atBoundary + 1.0)}
             : CoefficientRange{0.5 * range.atFlat, range.atBoundary};
}

Shading offNeutral(Shading shading) {
  if (shading.model == ShadingModel::classic) {
    shading.model = ShadingModel::enhanced;
    shading.exponentRange = {shading.exponent, shading.exponent};
    shading.opacityRange = {1.0, 1.0};
    shading.gradientCurve = {};
  }
  shading.diffuse = offZero(shading.diffuse);
  shading.specular = offZero(shading.specular);
  shading.lightIntensity = offZero(shading.lightIntensity);
  shading.exponentRange = widened(shading.exponentRange, 1024.0);
  shading.opacityRange = widened(shading.opacityRange, 8.0);
  if (shading.gradientCurve.type == GradientCurve::Type::gamma && shading.gradientCurve.parameter == 1.0)
    shading.gradientCurve.parameter = 2.0;
  return shading;
}

Scene offNeutral(Scene scene) {
  scene.shading = offNeutral(scene.shading);
  scene.fog.densityPerMm = scene.fog.densityPerMm > 0.0 ? scene.fog.densityPerMm : 1e-3;
  scene.fog.startMm = 0.0;
  return scene;
}

} // namespace

std::vector<Scene> neighbours(const Scene& scene) {
  std::vector<Scene> found{offNeutral(scene)};
  if (found.front().shading.gradientCurve.type == GradientCurve::Type::gamma) {
    found.push_back(found.front());
    found.back().shading.gradientCurve.parameter = 1.0;
  }
  if (scene.quality.preintegrated == Preintegration::automatic) {
    const std::vector<Scene> planned = found;
    found.clear();
    for (const Preintegration choice : {Preintegration::never, Preintegration::always})
      for (Scene one : planned) {
        one.quality.preintegrated = choice;
        found.push_back(one);
      }
  }
  return found;
}

} // namespace limn
