// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/SceneEdits.h"

#include "scene/presets/PresetFit.h"
#include "widgets/properties/ProjectionSection.h"

namespace limn {

Scene withProjection(Scene scene, Projection projection, const Histogram& histogram) {
  scene.projection = projection;
  if (!usesIsovalue(projection) || !scene.volume)
    return scene;
  const ValueRange& range = scene.volume->range();
  const bool isForeign = scene.isovalue == Scene{}.isovalue && !looksLikeHounsfield(*scene.volume);
  if (isForeign || scene.isovalue <= range.lowest || scene.isovalue >= range.highest)
    scene.isovalue = objectThreshold(histogram);
  return scene;
}

Camera withProjection(Camera camera, Camera::Projection projection) {
  if (projection == camera.projection)
    return camera;
  // What half the height is called depends on the projection.
  if (projection == Camera::Projection::orthographic)
    camera.heightMm = 2.0 * halfHeight(camera) * glm::length(camera.target - camera.position);
  camera.projection = projection;
  if (projection == Camera::Projection::perspective)
    camera.position = camera.target - basisOf(camera).forward * (camera.heightMm / 2.0 / halfHeight(camera));
  return camera;
}

} // namespace limn
