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

std::vector<NamedView> readViews(JsonFields& scene) {
  const nlohmann::json& list = scene.child("views");
  if (!list.is_array())
    scene.fail("views", Message::tr("must be a list of names with cameras"));
  std::vector<NamedView> views;
  for (const nlohmann::json& item : list) {
    JsonFields fields(item, scene.document(), placeIn(scene.pathOf("views").c_str(), views.size()));
    NamedView& view = views.emplace_back();
    if (!fields.text("name", view.name) || view.name.empty())
      fields.fail("name", Message::tr("is missing"));
    if (!fields.has("camera"))
      fields.fail("camera", Message::tr("is missing"));
    view.camera = readCamera(fields.object("camera"));
    fields.finish();
  }
  return views;
}

nlohmann::ordered_json viewsJson(const std::vector<NamedView>& views) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const NamedView& view : views)
    json.push_back({{"name", view.name}, {"camera", cameraJson(view.camera)}});
  return json;
}

} // namespace limn
