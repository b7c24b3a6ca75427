// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/light/Gradient.h"
#include "widgets/view/overlay/ViewGeometry.h"

#include <optional>

namespace limn {

/// What one sees at a pixel: the sample that gives the most to it.
struct Probe {
  double value = 0.0;         ///< scalar units, trilinear
  glm::dvec3 positionMm{0.0}; ///< world, LPS
  glm::dvec3 index{0.0};      ///< continuous voxel index
  bool operator==(const Probe&) const = default;
};

/// The sample along a ray that adds most to its pixel: the largest T·α, with α as the side's model and the
/// gradient opacity make it (a projection of extremes: the extreme sample; an isosurface: its first
/// crossing). `scale` maps gradients to r, where the model reads r. Marches at most half a voxel at a time.
/// Nothing where the ray misses the volume or all its samples together are below half an 8-bit level.
std::optional<Probe> probeAlong(const Scene& scene, const GradientScale& scale, const Ray& ray);

/// The ray through the device pixel under a point of a view, logical pixels; nothing beside the pictures.
std::optional<Ray> rayUnder(const ViewGeometry& geometry, const Camera& camera, const QPointF& point);

} // namespace limn
