// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/PlaneGrid.h"

#include "scene/volume/NearestVoxel.h"
#include "scene/volume/Orientation.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// Of LPS: the axis that runs across the plane.
int axisAcross(PatientPlane plane) {
  return plane == PatientPlane::axial ? 2 : plane == PatientPlane::coronal ? 1 : 0;
}

} // namespace

std::vector<glm::dvec3> cropOutline(const Grid& volume, const CropBox& crop, const PlaneGrid& plane) {
  if (crop == CropBox{})
    return {};
  const glm::dvec3 dims(volume.dims);
  const auto corner = [&](int which) {
    const glm::bvec3 isUpper(which & 1, which & 2, which & 4);
    return indexToWorld(volume, glm::mix(crop.lower, crop.upper, isUpper) * dims - 0.5);
  };
  const auto heightOf = [&](const glm::dvec3& place) {
    return glm::dot(place - plane.originMm, plane.axes.forward);
  };
  std::vector<glm::dvec3> crossings;
  for (int from = 0; from < 8; ++from)
    for (const int axis : {1, 2, 4}) {
      if (from & axis)
        continue;
      const glm::dvec3 a = corner(from);
      const glm::dvec3 b = corner(from | axis);
      // A face that lies in the plane belongs to the side above it.
      if ((heightOf(a) >= 0.0) != (heightOf(b) >= 0.0))
        crossings.push_back(glm::mix(a, b, heightOf(a) / (heightOf(a) - heightOf(b))));
    }
  // A cut through a box is convex.
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& place : crossings)
    middle += place / static_cast<double>(crossings.size());
  const auto angleOf = [&](const glm::dvec3& place) {
    return std::atan2(glm::dot(place - middle, plane.axes.down), glm::dot(place - middle, plane.axes.right));
  };
  std::ranges::sort(crossings, {}, angleOf);
  return crossings;
}

PlaneAxes axesOf(PatientPlane plane) {
  switch (plane) {
  case PatientPlane::axial:
    return {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  case PatientPlane::coronal:
    return {{1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, {0.0, -1.0, 0.0}};
  case PatientPlane::sagittal:
    return {{0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}, {1.0, 0.0, 0.0}};
  }
  return {};
}

glm::dvec3 pixelToWorld(const PlaneGrid& plane, const glm::dvec2& pixel) {
  return plane.originMm + plane.spacingMm * (pixel.x * plane.axes.right + pixel.y * plane.axes.down);
}

glm::dvec2 worldToPixel(const PlaneGrid& plane, const glm::dvec3& worldMm) {
  const glm::dvec3 offset = worldMm - plane.originMm;
  return glm::dvec2(glm::dot(offset, plane.axes.right), glm::dot(offset, plane.axes.down)) / plane.spacingMm;
}

PlaneGrid coarser(const PlaneGrid& plane, int factor) {
  PlaneGrid result = plane;
  result.originMm = pixelToWorld(plane, glm::dvec2((factor - 1) / 2.0));
  result.spacingMm = plane.spacingMm * factor;
  result.size = (plane.size + factor - 1) / factor;
  return result;
}

ReachMm reachAlong(const Grid& volume, const glm::dvec3& direction) {
  const double centre = glm::dot(boxCentreMm(volume), direction);
  double half = 0.0;
  for (int axis = 0; axis < 3; ++axis)
    half += std::abs(glm::dot(volume.direction[axis], direction)) * boxSizeMm(volume)[axis] / 2.0;
  return {centre - half, centre + half};
}

double sliceStepMm(const Grid& volume, PatientPlane plane) {
  const std::array<int, 3> axes = patientAxes(volume.direction);
  const auto across = std::find(axes.begin(), axes.end(), axisAcross(plane)) - axes.begin();
  return volume.spacingMm[static_cast<int>(across)];
}

glm::dvec3 middleVoxelMm(const Grid& volume) {
  return indexToWorld(volume, glm::dvec3((volume.dims - 1) / 2));
}

bool isInside(const Grid& volume, const glm::dvec3& worldMm) {
  return nearestVoxel(worldToIndex(volume, worldMm), volume.dims).has_value();
}

} // namespace limn
