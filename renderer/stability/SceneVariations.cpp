// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/SceneVariations.h"

#include "scene/Phantom.h"

namespace limn {
namespace {

void setFog(Scene& s, Fog::Mode mode) {
  s.fog = {mode, glm::dvec3(0.4, 0.5, 0.6), 0.002, 400.0, 1200.0};
}

void setProjection(Scene& s, Projection projection) {
  s.projection = projection;
  s.isovalue = 250.0;
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

const std::vector<Variation>& switches() {
  static const std::vector<Variation> all{
      {"nothing", [](Scene&) {}},
      {"unlit", [](Scene& s) { s.shading.model = ShadingModel::none; }},
      {"no diffuse", [](Scene& s) { s.shading.diffuse = 0.0; }},
      {"no specular", [](Scene& s) { s.shading.specular = 0.0; }},
      {"Phong", [](Scene& s) { s.shading.reflection = Reflection::phong; }},
      {"two-sided fixed light",
       [](Scene& s) {
         s.shading.lightDirection = glm::dvec3(1.0, 1.0, -1.0);
         s.shading.twoSided = true;
       }},
      {"highlights of the light", [](Scene& s) { s.shading.specularColor = SpecularColor::light; }},
      {"constant exponent",
       [](Scene& s) {
         s.shading.exponentRange = {20.0, 20.0};
       }},
      {"constant opacity coefficient",
       [](Scene& s) {
         s.shading.opacityRange = {1.5, 1.5};
       }},
      {"opacity coefficient 1",
       [](Scene& s) {
         s.shading.opacityRange = {1.0, 1.0};
       }},
      {"log curve",
       [](Scene& s) {
         s.shading.gradientCurve = {GradientCurve::Type::log, 20.0};
       }},
      {"gradient opacity",
       [](Scene& s) {
         s.gradientOpacity = GradientOpacity{{{0.0, 0.1}, {200.0, 1.0}}};
       }},
      {"no energy factor", [](Scene& s) { s.shading.energyFactor = false; }},
      {"no significance", [](Scene& s) { s.shading.significance.reset(); }},
      {"no knee", [](Scene& s) { s.shading.knee.reset(); }},
      {"linear fog", [](Scene& s) { setFog(s, Fog::Mode::linear); }},
      {"exponential fog", [](Scene& s) { setFog(s, Fog::Mode::exp); }},
      {"squared exponential fog", [](Scene& s) { setFog(s, Fog::Mode::exp2); }},
      {"crop",
       [](Scene& s) {
         s.crop = {{0.1, 0.3, 0.0}, {0.8, 1.0, 0.9}};
       }},
      {"no early termination", [](Scene& s) { s.quality.earlyTermination = 1.0; }},
      {"jitter", [](Scene& s) { s.quality.jitter = true; }},
      {"pre-integration", [](Scene& s) { s.quality.preintegrated = Preintegration::always; }},
      {"isosurface", [](Scene& s) { setProjection(s, Projection::isosurface); }},
      {"composite up to a surface", [](Scene& s) { setProjection(s, Projection::compositeIsosurface); }},
      {"X-ray", [](Scene& s) { setProjection(s, Projection::xray); }},
      {"maximum", [](Scene& s) { setProjection(s, Projection::mip); }}};
  return all;
}

const std::vector<Neutral>& neutralValues() {
  static const std::vector<Neutral> all{
      {"exponential fog",
       [](Scene& s) {
         s.fog = {Fog::Mode::exp, glm::dvec3(0.5), 0.0, 0.0, 0.0};
       },
       [](Scene& s) {
         s.fog = {Fog::Mode::exp, glm::dvec3(0.5), 1e-3, 0.0, 0.0};
       }},
      {"squared exponential fog",
       [](Scene& s) {
         s.fog = {Fog::Mode::exp2, glm::dvec3(0.5), 0.0, 0.0, 0.0};
       },
       [](Scene& s) {
         s.fog = {Fog::Mode::exp2, glm::dvec3(0.5), 1e-3, 0.0, 0.0};
       }},
      {"linear fog behind the volume",
       [](Scene& s) {
         s.fog = {Fog::Mode::linear, glm::dvec3(0.5), 0.0, 3000.0, 4000.0};
       },
       [](Scene& s) {
         s.fog = {Fog::Mode::linear, glm::dvec3(0.5), 0.0, 700.0, 2000.0};
       }},
      {"specular term", [](Scene& s) { s.shading.specular = 0.0; },
       [](Scene& s) { s.shading.specular = 1e-3; }},
      {"diffuse term", [](Scene& s) { s.shading.diffuse = 0.0; }, [](Scene& s) { s.shading.diffuse = 1e-3; }},
      {"exponent map",
       [](Scene& s) {
         s.shading.exponentRange = {20.0, 20.0};
       },
       [](Scene& s) {
         s.shading.exponentRange = {20.0, 20.001};
       }},
      {"opacity map",
       [](Scene& s) {
         s.shading.opacityRange = {1.0, 1.0};
       },
       [](Scene& s) {
         s.shading.opacityRange = {1.0, 1.001};
       }},
      {"opacity factor",
       [](Scene& s) {
         s.shading.opacityRange = {1.0, 1.0};
       },
       [](Scene& s) {
         s.shading.opacityRange = {1.001, 1.001};
       }},
      {"gradient opacity", [](Scene& s) { s.gradientOpacity.reset(); },
       [](Scene& s) {
         s.gradientOpacity = GradientOpacity{{{0.0, 0.999}, {100.0, 1.0}}};
       }},
      {"significance", [](Scene& s) { s.shading.significance.reset(); },
       [](Scene& s) {
         s.shading.significance = Significance{0.0, 1e-3};
       }},
      {"knee", [](Scene& s) { s.shading.knee = 1.75; }, // the terms sum to 0.25 + 0.75 + 0.75
       [](Scene& s) { s.shading.knee = 0.999; }},
      {"crop box", [](Scene& s) { s.crop = {}; },
       [](Scene& s) {
         // A thousandth beyond where the head begins.
         s.crop.lower.z = 0.501;
       }},
      {"early termination", [](Scene& s) { s.quality.earlyTermination = 1.0; },
       [](Scene& s) { s.quality.earlyTermination = 0.999; }},
      {"jitter", [](Scene& s) { s.quality.jitter = false; }, [](Scene& s) { s.quality.jitter = true; }},
      {"light", [](Scene& s) { s.shading.model = ShadingModel::none; },
       [](Scene& s) {
         s.shading.ambientIntensity = 0.999;
         s.shading.diffuse = 0.0;
         s.shading.specular = 0.0;
         s.shading.opacityRange = {1.0, 1.0};
       }}};
  return all;
}

} // namespace limn
