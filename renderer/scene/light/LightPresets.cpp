// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/LightPresets.h"

#include "scene/light/LightingTerms.h"
#include "scene/view/Camera.h"

#include <algorithm>

namespace limn {
namespace {

// All that a preset sets.
struct Light {
  std::optional<glm::dvec3> direction; // travels, in the camera's axes
  double ambient, lamp;                // Ia, Id
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
    return {aboveLeft, 0.35, 1.21, {0.85, 4.0}, {0.8, 15.0}};
  case LightPreset::softStudio:
    return {aboveLeft, 0.38, 1.05, {0.75, 20.0}, {0.8, 15.0}};
  case LightPreset::overcast:
    return {glm::normalize(glm::dvec3(0.0, -1.0, 0.35)), 0.75, 0.48, {0.8, 45.0}, {1.0, 30.0}};
  }
  const Shading initial;
  return {std::nullopt, initial.ambientIntensity, initial.lightIntensity, {}, {}};
}

} // namespace

Shading withLight(Shading shading, LightPreset preset) {
  const Light light = lightOf(preset);
  shading.lightDirection = light.direction;
  shading.lightAxes = light.direction ? LightAxes::camera : LightAxes::world;
  shading.ambientIntensity = light.ambient;
  shading.lightIntensity = light.lamp;
  shading.shadow = light.shadow;
  shading.occlusion = light.occlusion;
  return shading;
}

std::optional<LightPreset> lightPresetOf(const Shading& shading) {
  const auto found = std::ranges::find_if(
      lightPresets, [&](LightPreset preset) { return withLight(shading, preset) == shading; });
  return found == lightPresets.end() ? std::nullopt : std::optional(*found);
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
  shading.lightDirection =
      shading.lightAxes == LightAxes::camera
          ? travels
          : travels.x * basis.right + travels.y * basis.up + travels.z * basis.forward;
  return shading;
}

} // namespace limn
