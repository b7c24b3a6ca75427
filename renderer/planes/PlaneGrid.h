// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "scene/view/PlaneSettings.h"
#include "scene/volume/Grid.h"

#include <vector>

namespace limn {

/// How a plane of the patient is looked at, in LPS, as radiologists do: axial from the feet, coronal from the
/// front, sagittal from the patient's left. So the patient's right is at the left of an axial and a coronal
/// slice, and the front at the left of a sagittal one.
struct PlaneAxes {
  glm::dvec3 right{1.0, 0.0, 0.0}; ///< unit vectors; as seen
  glm::dvec3 down{0.0, 1.0, 0.0};
  glm::dvec3 forward{0.0, 0.0, 1.0}; ///< the way of "next slice": to the head, the front, the left
};

/// The axes of each of the three, world LPS.
PlaneAxes axesOf(PatientPlane plane);

/// Square pixels on a plane, in the patient's millimetres.
struct PlaneGrid {
  glm::ivec2 size{0};       ///< pixels
  glm::dvec3 originMm{0.0}; ///< centre of the upper left pixel
  PlaneAxes axes;
  double spacingMm = 1.0; ///< between the centres of pixels, > 0
  bool operator==(const PlaneGrid& other) const {
    return size == other.size && originMm == other.originMm && axes.right == other.axes.right &&
           axes.down == other.axes.down && spacingMm == other.spacingMm;
  }
};

/// The centre of a pixel, x to the right and y down; fractions lie between.
glm::dvec3 pixelToWorld(const PlaneGrid& plane, const glm::dvec2& pixel);

/// The pixel that a place in the world is seen at, which need not lie in the plane.
glm::dvec2 worldToPixel(const PlaneGrid& plane, const glm::dvec3& worldMm);

/// The same place with one pixel for each `factor` × `factor` ≥ 1 of them; the last ones may reach beyond.
PlaneGrid coarser(const PlaneGrid& plane, int factor);

/// Where the volume's box begins and ends along a direction of unit length, mm from the world's origin.
struct ReachMm {
  double first = 0.0;
  double last = 0.0;
};
ReachMm reachAlong(const Grid& volume, const glm::dvec3& direction);

/// From one slice to the next, mm: the spacing of the grid axis that runs most nearly across the plane.
double sliceStepMm(const Grid& volume, PatientPlane plane);

/// The centre of the voxel in the middle of the volume (of an even number the one before), world millimetres.
glm::dvec3 middleVoxelMm(const Grid& volume);

/// Whether a place lies in the volume's box.
bool isInside(const Grid& volume, const glm::dvec3& worldMm);

/// Where a plane cuts the crop box: the corners of that polygon in their order around it, world millimetres.
/// None where the crop cuts nothing of the volume or the plane misses the box.
std::vector<glm::dvec3> cropOutline(const Grid& volume, const CropBox& crop, const PlaneGrid& plane);

} // namespace limn
