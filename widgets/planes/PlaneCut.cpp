// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/PlaneCut.h"

#include <algorithm>

namespace limn {
namespace {

// So far before the volume stands the camera: farther than any slab reaches.
constexpr double beforeMm = thickestSlabMm;

} // namespace

Scissors scissorsOn(const PlaneContent& content, const PlaneFrame& frame, const CutLine& line,
                    bool removesInside) {
  const PlaneAxes& axes = frame.grid.axes;
  // What a slice's right and down make is the way in which it is looked at: coronal slices from the front.
  const glm::dvec3 into = glm::cross(axes.right, axes.down);
  Camera camera;
  camera.projection = Camera::Projection::orthographic;
  camera.target = worldAt(frame, line.picture.center());
  const double toSlice = glm::dot(camera.target, into) - reachAlong(content.volume->grid(), into).first;
  camera.position = camera.target - (std::max(0.0, toSlice) + beforeMm) * into;
  camera.up = -axes.down;
  camera.heightMm = line.picture.height() * mmPerLogicalPixel(frame);
  return {camera, line.picture.width() / line.picture.height(), polygonOf(line), removesInside, {}};
}

glm::dvec2 slabDepthMm(const PlaneContent& content, PatientPlane plane, const Scissors& scissors) {
  const double toSlice = glm::length(scissors.camera.target - scissors.camera.position);
  const double half =
      std::max(content.settings.slab.thicknessMm, sliceStepMm(content.volume->grid(), plane)) / 2.0;
  return {std::max(0.0, toSlice - half), toSlice + half};
}

} // namespace limn
