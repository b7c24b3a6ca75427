// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/LightPresets.h"

#include "scene/light/LightingTerms.h"
#include "scene/view/Camera.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// All that a preset sets, and by what it raises Ia and Id over those of a headlight.
struct Light {
  std::optional<glm::dvec3> direction; // travels, in the camera's axes
  double ambientGain = 1.0, lampGain = 1.0;
  Shadow shadow;
  Occlusion occlusion;
};

Light lightOf(LightPreset preset) {
  // From above and from the left, before the picture, as a drawing is lit.
  const glm::dvec3 aboveLeft = glm::normalize(glm::dvec3(0.5, -0.62, 0.6));
  switch (preset) {
  case LightPreset::headlight:
    break;
  case LightPreset::studio:
  case LightPreset::physical:
    return {aboveLeft, 1.7, 1.25, {0.85, 4.0}, {0.8, 15.0}};
  case LightPreset::softStudio:
    return {aboveLeft, 1.75, 1.15, {0.75, 20.0}, {0.8, 15.0}};
  case LightPreset::overcast:
    return {glm::normalize(glm::dvec3(0.0, -1.0, 0.35)), 2.7, 0.6, {0.8, 45.0}, {1.0, 30.0}};
  }
  return {};
}

// The lamp is as large as the studio's, the sky brighter above than below.
PhysicalLight physicalLight() {
  PhysicalLight light;
  light.sky = {0.2, 0.5};
  light.exposureEv = 0.0;
  return light;
}

// Of physical light: what shows where it comes from, not how strong it is.
bool hasLightOfPreset(const PhysicalLight& light) {
  const PhysicalLight preset = physicalLight();
  return light.keyRadiusDeg == preset.keyRadiusDeg && light.sky == preset.sky;
}

// What came of a product of such gains and was none before is none again.
double withoutRounding(double strength) {
  return std::round(1e6 * strength) / 1e6;
}

// The headlight from which the light of a preset was made.
LightStrengths headlightUnder(const Shading& shading) {
  const std::optional<LightPreset> known = lightPresetOf(shading);
  if (!known)
    return {};
  const Light light = lightOf(*known);
  return {shading.ambientIntensity / light.ambientGain, shading.lightIntensity / light.lampGain};
}

} // namespace

Shading withLight(Shading shading, LightPreset preset, const std::optional<LightStrengths>& ofHeadlight) {
  const Light light = lightOf(preset);
  const LightStrengths headlight = ofHeadlight ? *ofHeadlight : headlightUnder(shading);
  shading.ambientIntensity = withoutRounding(headlight.ambient * light.ambientGain);
  shading.lightIntensity = withoutRounding(headlight.lamp * light.lampGain);
  shading.lightDirection = light.direction;
  shading.lightAxes = light.direction ? LightAxes::camera : LightAxes::world;
  shading.shadow = light.shadow;
  shading.occlusion = light.occlusion;
  if (preset == LightPreset::physical) {
    const PhysicalLight physical = physicalLight();
    shading.model = ShadingModel::physical;
    shading.physical.keyIrradiance = physical.keyIrradiance;
    shading.physical.keyRadiusDeg = physical.keyRadiusDeg;
    shading.physical.sky = physical.sky;
    shading.physical.exposureEv = physical.exposureEv;
  } else if (shading.model == ShadingModel::physical) {
    shading.model = Shading().model;
  }
  return shading;
}

std::optional<LightPreset> lightPresetOf(const Shading& shading) {
  const auto isOf = [&](LightPreset preset) {
    const Light light = lightOf(preset);
    return shading.lightDirection == light.direction && shading.shadow == light.shadow &&
           shading.occlusion == light.occlusion &&
           (preset == LightPreset::physical) ==
               (shading.model == ShadingModel::physical && hasLightOfPreset(shading.physical)) &&
           (!light.direction || shading.lightAxes == LightAxes::camera);
  };
  const auto found = std::ranges::find_if(lightPresets, isOf);
  return found == lightPresets.end() ? std::nullopt : std::optional(*found);
}

const char* nameOf(LightPreset preset) {
  constexpr std::array names{"headlight", "studio", "soft-studio", "overcast", "physical"};
  return names[static_cast<std::size_t>(preset)];
}

glm::dvec3 seenFromViewer(const Shading& shading, const Camera& camera) {
  const std::optional<glm::dvec3> travels = lightTravels(shading, camera);
  if (!travels || glm::length(*travels) == 0.0)
    return {0.0, 0.0, 1.0};
  const CameraBasis basis = basisOf(camera);
  const glm::dvec3 from = -glm::normalize(*travels);
  return {glm::dot(from, basis.right), glm::dot(from, basis.up), -glm::dot(from, basis.forward)};
}

Shading withLightSeenAt(Shading shading, const glm::dvec3& place, const Camera& camera) {
  const glm::dvec3 travels(-place.x, -place.y, place.z); // right, up, forward
  if (!shading.lightDirection)
    shading.lightAxes = LightAxes::camera;
  const CameraBasis basis = basisOf(camera);
  shading.lightDirection = shading.lightAxes == LightAxes::camera
                               ? travels
                               : travels.x * basis.right + travels.y * basis.up + travels.z * basis.forward;
  return shading;
}

} // namespace limn
