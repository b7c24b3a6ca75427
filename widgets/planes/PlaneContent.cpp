// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/planes/PlaneContent.h"

#include "planes/PlaneGrid.h"

#include <algorithm>

namespace limn {
namespace {

// The plane whose slices follow each other along an axis of the patient.
PatientPlane planeAcross(int axis) {
  return axis == 0 ? PatientPlane::sagittal : axis == 1 ? PatientPlane::coronal : PatientPlane::axial;
}

glm::dvec3 withinSlices(const Grid& grid, glm::dvec3 place) {
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    const ReachMm reach = reachAlong(grid, direction);
    const double half = std::min(sliceStepMm(grid, planeAcross(axis)), reach.last - reach.first) / 2.0;
    place[axis] =
        std::clamp(place[axis], reach.first + half, std::max(reach.first + half, reach.last - half));
  }
  return place;
}

} // namespace

glm::dvec3 crosshairOf(const PlaneContent& content) {
  return content.settings.crosshairMm.value_or(middleVoxelMm(content.volume->grid()));
}

Grid seenGrid(const PlaneContent& content) {
  const Grid& all = content.volume->grid();
  if (content.keep.kind != Region::Kind::body || !content.keep.labels)
    return all;
  const VoxelBox& body = content.keep.labels->boxAround(1);
  return body.lower == body.upper ? all : partOf(all, widened(body, all));
}

GreyWindow windowOf(const PlaneContent& content) {
  return content.settings.window.value_or(content.firstWindow);
}

std::optional<double> valueUnderCrosshair(const PlaneContent& content) {
  if (!content.volume || !isInside(content.volume->grid(), crosshairOf(content)))
    return std::nullopt;
  return valueAt(*content.volume, worldToIndex(content.volume->grid(), crosshairOf(content)));
}

PlaneSettings withCrosshair(const PlaneContent& content, const glm::dvec3& worldMm) {
  PlaneSettings settings = content.settings;
  settings.crosshairMm = withinSlices(content.volume->grid(), worldMm);
  return settings;
}

PlaneSettings withCrosshairMoved(const PlaneContent& content, const glm::dvec3& direction, int slices) {
  const glm::dvec3 size = glm::abs(direction);
  const int axis = size.x > 0.5 ? 0 : size.y > 0.5 ? 1 : 2;
  const double step = sliceStepMm(content.volume->grid(), planeAcross(axis));
  return withCrosshair(content, crosshairOf(content) + slices * step * direction);
}

PlaneSettings withLargeToggled(PlaneSettings settings, PatientPlane plane) {
  const bool isLarge = settings.layout == PlaneLayout::oneLarge && settings.large == plane;
  settings.layout = isLarge ? PlaneLayout::pictureAndThree : PlaneLayout::oneLarge;
  settings.large = plane;
  return settings;
}

} // namespace limn
