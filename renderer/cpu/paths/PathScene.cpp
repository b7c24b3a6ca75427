// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/paths/PathScene.h"

#include "cpu/paths/Tone.h"
#include "scene/light/LightingTerms.h"
#include "scene/view/Camera.h"

#include <algorithm>
#include <cmath>

namespace limn::cpu {
namespace {

void makeDense(TransferFunction& function, double density) {
  function.unitDistanceMm /= density;
}

IndexBox shared(const IndexBox& a, const IndexBox& b) {
  return {glm::max(a.lower, b.lower), glm::min(a.upper, b.upper)};
}

void setLights(const Scene& scene, PathTerms& paths) {
  const Grid& grid = scene.volume->grid();
  const Shading& shading = scene.shading;
  const PhysicalLight& light = shading.physical;
  const double cosine = std::cos(glm::radians(light.keyRadiusDeg));
  // Of a disc whose radiance gives this irradiance: E / (π sin²) times its solid angle.
  paths.keyFluence = static_cast<float>(2.0 * light.keyIrradiance / (1.0 + cosine));
  paths.keyCosine = light.keyRadiusDeg > 0.0 ? static_cast<float>(cosine) : 1.0f;
  const std::optional<glm::dvec3> travels = lightTravels(shading, scene.camera);
  paths.isHeadlight = !travels;
  if (travels)
    paths.towardsKey = glm::vec3(towardsLightAlongAxes(*travels, grid));
  paths.skyBelow = static_cast<float>(light.sky.below);
  paths.skyAbove = static_cast<float>(light.sky.above);
  const bool turnsWithCamera = !travels || shading.lightAxes == LightAxes::camera;
  const glm::dvec3 up = turnsWithCamera ? basisOf(scene.camera).up : glm::dvec3(0.0, 0.0, 1.0);
  paths.up = glm::vec3(towardsLightAlongAxes(-up, grid));
}

void setSurfaces(const Scene& scene, const PictureTerms& terms, PathTerms& paths) {
  const PhysicalLight& light = scene.shading.physical;
  paths.anisotropy = static_cast<float>(light.anisotropy);
  paths.surface = static_cast<float>(light.surface);
  paths.specularShare = static_cast<float>(light.specularShare);
  paths.exponentAtFlat = static_cast<float>(scene.shading.exponentRange.atFlat);
  paths.exponentAtBoundary = static_cast<float>(scene.shading.exponentRange.atBoundary);
  paths.gradientScale = terms.gradientScale;
  paths.flatModulus = terms.flatModulus;
  paths.perReference = terms.perReference;
  paths.curve = scene.shading.gradientCurve;
  paths.isCut = scene.crop != CropBox{};
  paths.cutLower = glm::vec3(terms.cut.lower + terms.centre);
  paths.cutUpper = glm::vec3(terms.cut.upper + terms.centre);
}

} // namespace

Scene mediumOf(const Scene& scene) {
  Scene medium = scene;
  const double density = scene.shading.physical.density;
  makeDense(medium.transferFunction, density);
  for (TransferFunction& look : medium.keep.looks)
    makeDense(look, density);
  medium.fog = {};
  medium.projection = Projection::composite;
  return medium;
}

Scene alphaOf(const Scene& scene) {
  Scene alpha = mediumOf(scene);
  alpha.shading.model = ShadingModel::none;
  alpha.quality.earlyTermination = 1.0;
  return alpha;
}

PathTerms pathTerms(const Scene& medium, const PictureTerms& terms) {
  PathTerms paths;
  paths.voxels = terms.voxels;
  paths.smoothed = terms.smoothed;
  paths.smoothsNormals = terms.effects.has(Effect::smoothNormals);
  paths.function = terms.function;
  if (medium.gradientOpacity && !medium.gradientOpacity->points.empty())
    paths.gradientCurve = terms.gradientCurve;
  paths.region = terms.region;
  paths.hasRegion = isRestricting(medium.keep);
  paths.perUnitDistance = terms.perUnitDistance;
  paths.range = medium.volume->range();
  paths.perLength = glm::vec3(1.0 / terms.spacing);
  paths.spacing = glm::vec3(terms.spacing);
  const IndexBox box = shared(terms.box, terms.visibleBox);
  paths.lower = glm::vec3(box.lower + terms.centre);
  paths.upper = glm::vec3(box.upper + terms.centre);
  setSurfaces(medium, terms, paths);
  setLights(medium, paths);
  for (std::size_t i = 0; i < paths.linear.size(); ++i)
    paths.linear[i] =
        static_cast<float>(decoded(std::min(static_cast<double>(i) / PathTerms::linearSteps, 1.0)));
  return paths;
}

PathStart pathStart(const PathTerms& paths, const PictureTerms& terms, int x, int y) {
  const FramedRay ray = framedRay(terms.frame, x, y, terms.size);
  const RaySpan span = spanInBox(ray, shared(terms.box, terms.visibleBox));
  PathStart start;
  if (span.isEmpty())
    return start;
  start.place =
      glm::clamp(glm::vec3(ray.anchor + span.begin * ray.direction + terms.centre), paths.lower, paths.upper);
  start.direction = glm::vec3(glm::normalize(ray.direction * terms.spacing));
  start.length = static_cast<float>((span.end - span.begin) / terms.lengthMm);
  return start;
}

} // namespace limn::cpu
