// SPDX-License-Identifier: GPL-3.0-or-later
#include "EffectSwitches.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace limn::test {
namespace {

Variation parameter(const std::string& what) {
  const std::vector<Variation>& all = everyParameter();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Variation& one) { return one.what == what; });
  return found != all.end() ? *found : throw std::logic_error("no parameter is called " + what);
}

} // namespace

const std::vector<Variation>& switches() {
  static const std::vector<Variation> all{
      {"nothing", [](Scene&) {}},
      {"unlit", [](Scene& s) { s.shading.model = ShadingModel::none; }},
      {"no diffuse", [](Scene& s) { s.shading.diffuse = 0.0; }},
      {"no specular", [](Scene& s) { s.shading.specular = 0.0; }},
      parameter("Phong"),
      parameter("two-sided fixed light"),
      parameter("highlights of the light"),
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
      parameter("log curve"),
      parameter("gradient opacity"),
      parameter("no energy factor"),
      parameter("no significance"),
      parameter("no knee"),
      parameter("linear fog"),
      parameter("exponential fog"),
      parameter("squared exponential fog"),
      {"crop",
       [](Scene& s) {
         s.crop = {{0.1, 0.3, 0.0}, {0.8, 1.0, 0.9}};
       }},
      {"no early termination", [](Scene& s) { s.quality.earlyTermination = 1.0; }},
      parameter("jitter"),
      parameter("pre-integration"),
      parameter("isosurface"),
      parameter("composite up to a surface"),
      parameter("X-ray"),
      parameter("maximum")};
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

} // namespace limn::test
