// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/effects/UsualEffects.h"

#include "scene/light/LightPresets.h"

#include <functional>
#include <map>

namespace limn {
namespace {

using SwitchOn = std::function<void(Scene& scene)>;

double ownOr(double own, double usual) {
  return own > 0.0 ? own : usual;
}

void castShadows(Shading& shading) {
  const Shading studio = withLight(Shading(), LightPreset::studio);
  if (shading.shadow == Shadow{})
    shading.shadow = studio.shadow;
  shading.shadow.strength = ownOr(shading.shadow.strength, studio.shadow.strength);
  if (shading.lightDirection)
    return;
  shading.lightDirection = studio.lightDirection;
  shading.lightAxes = studio.lightAxes;
}

void darkenHollows(Shading& shading) {
  const Shading studio = withLight(Shading(), LightPreset::studio);
  if (shading.occlusion == Occlusion{})
    shading.occlusion = studio.occlusion;
  shading.occlusion.strength = ownOr(shading.occlusion.strength, studio.occlusion.strength);
}

const std::map<std::string, SwitchOn>& switches() {
  static const std::map<std::string, SwitchOn> all{
      {"specular", [](Scene& scene) { scene.shading.specular = Shading().specular; }},
      {"knee", [](Scene& scene) { scene.shading.knee = Shading().knee; }},
      {"two_sided", [](Scene& scene) { scene.shading.twoSided = true; }},
      {"shadow", [](Scene& scene) { castShadows(scene.shading); }},
      {"occlusion", [](Scene& scene) { darkenHollows(scene.shading); }},
      {"jitter", [](Scene& scene) { scene.quality.jitter = true; }},
      {"preintegration", [](Scene& scene) { scene.quality.preintegrated = Preintegration::always; }},
      {"early_termination",
       [](Scene& scene) { scene.quality.earlyTermination = Quality().earlyTermination; }}};
  return all;
}

} // namespace

std::optional<Scene> withUsualEffect(const Scene& scene, const EffectRow& row, const SceneFacts& facts) {
  const auto found = switches().find(row.name);
  if (row.isOn || !scene.volume || found == switches().end())
    return std::nullopt;
  Scene with = scene;
  found->second(with);
  if (!requiredEffects(with, facts).effects.hasAny(row.effects))
    return std::nullopt;
  return with;
}

} // namespace limn
