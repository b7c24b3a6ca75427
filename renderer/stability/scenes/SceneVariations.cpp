// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/scenes/SceneVariations.h"

#include "scene/volume/Phantom.h"
#include "stability/scenes/SimpleScenes.h"

#include <algorithm>

namespace limn {
namespace {

void setFog(Scene& s, Fog::Mode mode) {
  s.fog = {mode, glm::dvec3(0.4, 0.5, 0.6), 0.002, 400.0, 1200.0};
}

void setProjection(Scene& s, Projection projection) {
  s.projection = projection;
  s.isovalue = 250.0;
}

// The lower half is kept.
Region halfBody(const glm::ivec3& dims) {
  std::vector<std::uint8_t> places(static_cast<std::size_t>(dims.x) * dims.y * dims.z, 1);
  std::fill(places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2), places.end(), std::uint8_t{0});
  return bodyRegion(dims, places);
}

} // namespace

const std::vector<Variation>& everyParameter() {
  static const std::vector<Variation> all{
      {"volume", [](Scene& s) { s.volume = phantomVolume({.spacingMm = 7.0}); }},
      {"camera", [](Scene& s) { s.camera = orbited(s.camera, 0.5, 0.1); }},
      {"orthographic", [](Scene& s) { s.camera.projection = Camera::Projection::orthographic; }},
      {"unit distance", [](Scene& s) { s.transferFunction.unitDistanceMm = 2.0; }},
      {"opacity of a point", [](Scene& s) { s.transferFunction.points[3].opacity = 0.3; }},
      {"value of a point", [](Scene& s) { s.transferFunction.points[3].value += 15.0; }},
      {"colour of a point", [](Scene& s) { s.transferFunction.points[3].color = glm::dvec3(0.1, 0.9, 0.1); }},
      {"no model", [](Scene& s) { s.shading.model = ShadingModel::none; }},
      {"classic", [](Scene& s) { s.shading.model = ShadingModel::classic; }},
      {"enhanced", [](Scene& s) { s.shading.model = ShadingModel::enhanced; }},
      {"classic exponent",
       [](Scene& s) {
         s.shading.model = ShadingModel::classic;
         s.shading.exponent = 8.0;
       }},
      {"ambient", [](Scene& s) { s.shading.ambient = 0.5; }},
      {"diffuse", [](Scene& s) { s.shading.diffuse = 0.5; }},
      {"specular", [](Scene& s) { s.shading.specular = 0.3; }},
      {"ambient intensity", [](Scene& s) { s.shading.ambientIntensity = 0.4; }},
      {"light intensity", [](Scene& s) { s.shading.lightIntensity = 0.5; }},
      {"SPmin", [](Scene& s) { s.shading.exponentRange.atFlat = 4.0; }},
      {"SPmax", [](Scene& s) { s.shading.exponentRange.atBoundary = 100.0; }},
      {"Omin", [](Scene& s) { s.shading.opacityRange.atFlat = 0.5; }},
      {"Omax", [](Scene& s) { s.shading.opacityRange.atBoundary = 2.0; }},
      {"reference: largest", [](Scene& s) { s.shading.gradientReference = LargestReference{}; }},
      {"reference: percentile", [](Scene& s) { s.shading.gradientReference = PercentileReference{90.0}; }},
      {"reference: fixed", [](Scene& s) { s.shading.gradientReference = FixedReference{150.0}; }},
      {"gamma curve",
       [](Scene& s) {
         s.shading.gradientCurve = {GradientCurve::Type::gamma, 0.5};
       }},
      {"log curve",
       [](Scene& s) {
         s.shading.gradientCurve = {GradientCurve::Type::log, 20.0};
       }},
      {"no energy factor", [](Scene& s) { s.shading.energyFactor = false; }},
      {"significance",
       [](Scene& s) {
         s.shading.significance = Significance{0.2, 0.6};
       }},
      {"no significance", [](Scene& s) { s.shading.significance.reset(); }},
      {"knee", [](Scene& s) { s.shading.knee = 0.3; }},
      {"no knee", [](Scene& s) { s.shading.knee.reset(); }},
      {"highlights of the light", [](Scene& s) { s.shading.specularColor = SpecularColor::light; }},
      {"Phong", [](Scene& s) { s.shading.reflection = Reflection::phong; }},
      {"fixed light", [](Scene& s) { s.shading.lightDirection = glm::dvec3(1.0, 1.0, -1.0); }},
      {"two-sided fixed light",
       [](Scene& s) {
         s.shading.lightDirection = glm::dvec3(1.0, 1.0, -1.0);
         s.shading.twoSided = true;
       }},
      {"gradient opacity",
       [](Scene& s) {
         s.gradientOpacity = GradientOpacity{{{0.0, 0.1}, {200.0, 1.0}}};
       }},
      {"linear fog", [](Scene& s) { setFog(s, Fog::Mode::linear); }},
      {"exponential fog", [](Scene& s) { setFog(s, Fog::Mode::exp); }},
      {"squared exponential fog", [](Scene& s) { setFog(s, Fog::Mode::exp2); }},
      {"crop, left", [](Scene& s) { s.crop.lower.x = 0.4; }},
      {"crop, above", [](Scene& s) { s.crop.upper.z = 0.6; }},
      {"kept region",
       [](Scene& s) {
         s.keep = cubesRegion(s.volume->grid().dims, 7, {1.0, 0.0, 0.4});
       }},
      {"body", [](Scene& s) { s.keep = halfBody(s.volume->grid().dims); }},
      {"step", [](Scene& s) { s.quality.stepVoxels = 0.7; }},
      {"early termination", [](Scene& s) { s.quality.earlyTermination = 0.7; }},
      {"pre-integration", [](Scene& s) { s.quality.preintegrated = Preintegration::always; }},
      {"jitter", [](Scene& s) { s.quality.jitter = true; }},
      {"maximum", [](Scene& s) { setProjection(s, Projection::mip); }},
      {"average", [](Scene& s) { setProjection(s, Projection::average); }},
      {"minimum", [](Scene& s) { setProjection(s, Projection::minip); }},
      {"X-ray", [](Scene& s) { setProjection(s, Projection::xray); }},
      {"isosurface", [](Scene& s) { setProjection(s, Projection::isosurface); }},
      {"another isosurface",
       [](Scene& s) {
         s.projection = Projection::isosurface;
         s.isovalue = -200.0;
       }},
      {"composite up to a surface", [](Scene& s) { setProjection(s, Projection::compositeIsosurface); }}};
  return all;
}

} // namespace limn
