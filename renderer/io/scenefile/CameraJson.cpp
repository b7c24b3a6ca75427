// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/scenefile/SceneJson.h"

#include <nlohmann/json.hpp>

namespace limn {
namespace {

constexpr Words<Camera::Projection, 2> cameraWords{{"perspective", "orthographic"}};

nlohmann::ordered_json listOf(const glm::dvec3& v) {
  return nlohmann::ordered_json::array({v.x, v.y, v.z});
}

} // namespace

Camera readCamera(JsonFields fields) {
  Camera camera;
  fields.choice("projection", camera.projection, cameraWords);
  fields.vector("position", camera.position);
  fields.vector("target", camera.target);
  fields.vector("up", camera.up);
  fields.number("fov_y_deg", camera.fovYDeg, {0.0, 170.0, true});
  fields.number("height_mm", camera.heightMm, positive);
  fields.finish();
  return camera;
}

nlohmann::ordered_json cameraJson(const Camera& camera) {
  return {{"projection", cameraWords.of(camera.projection)},
          {"position", listOf(camera.position)},
          {"target", listOf(camera.target)},
          {"up", listOf(camera.up)},
          {"fov_y_deg", camera.fovYDeg},
          {"height_mm", camera.heightMm}};
}

} // namespace limn
