// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/panels/EffectSwitches.h"

#include <functional>
#include <map>

namespace limn {
namespace {

/// How one effect is switched off, and taken from a scene that has it.
struct Switch {
  std::function<void(Scene& scene)> leaveOut;
  std::function<void(Scene& scene, const Scene& from)> take;
};

template <class Whole, class Part>
Switch ofPart(Whole Scene::*whole, Part Whole::*part, const Part& off) {
  return {[=](Scene& scene) { scene.*whole.*part = off; },
          [=](Scene& scene, const Scene& from) { scene.*whole.*part = from.*whole.*part; }};
}

template <class Part>
Switch ofScene(Part Scene::*part, const Part& off) {
  return {[=](Scene& scene) { scene.*part = off; },
          [=](Scene& scene, const Scene& from) { scene.*part = from.*part; }};
}

const std::map<std::string, Switch>& switches() {
  static const std::map<std::string, Switch> all{
      {"specular", ofPart(&Scene::shading, &Shading::specular, 0.0)},
      {"opacity_map", ofPart(&Scene::shading, &Shading::opacityRange, {1.0, 1.0})},
      {"gradient_curve", ofPart(&Scene::shading, &Shading::gradientCurve, {})},
      {"knee", ofPart(&Scene::shading, &Shading::knee, {})},
      {"two_sided", ofPart(&Scene::shading, &Shading::twoSided, false)},
      {"fog", ofScene(&Scene::fog, {})},
      {"crop", ofScene(&Scene::crop, {})},
      {"gradient_opacity", ofScene(&Scene::gradientOpacity, {})},
      {"jitter", ofPart(&Scene::quality, &Quality::jitter, false)},
      {"early_termination", ofPart(&Scene::quality, &Quality::earlyTermination, 1.0)},
      {"preintegration", ofPart(&Scene::quality, &Quality::preintegrated, Preintegration::never)}};
  return all;
}

} // namespace

std::optional<Scene> withoutEffect(Scene scene, const std::string& effect) {
  const auto found = switches().find(effect);
  if (found == switches().end())
    return std::nullopt;
  found->second.leaveOut(scene);
  return scene;
}

Scene withEffect(Scene scene, const std::string& effect, const Scene& before) {
  const auto found = switches().find(effect);
  if (found != switches().end())
    found->second.take(scene, before);
  return scene;
}

} // namespace limn
