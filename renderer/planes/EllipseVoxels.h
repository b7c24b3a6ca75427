// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Measurement.h"
#include "scene/volume/Volume.h"

namespace limn {

/// An ellipse in a slice, with its axes along those of the plane.
struct EllipseShape {
  glm::dvec3 centreMm{0.0};   ///< world
  glm::dvec2 semiAxesMm{0.0}; ///< ≥ 0; to the right and down, as the plane is looked at
};

/// The shape of a measurement that is an ellipse.
EllipseShape shapeOf(const Measurement& ellipse);

/// What the voxels of a volume say whose centres lie in an ellipse and within half a slice of its plane;
/// where a plane lies between two slices they are those of the one before it, never of both. Invalid voxels
/// count for nothing. The area is that of the ellipse, whatever the voxels.
EllipseFigures ellipseFigures(const Volume& volume, const Measurement& ellipse);

/// Measurements with what they say of a volume; without one, ellipses have their area alone. Ellipses that
/// lie as one of `before`, which is of the same volume, are not read again.
std::vector<Measured> measuredIn(const Volume* volume, const std::vector<Measurement>& measurements,
                                 const std::vector<Measured>& before = {});

} // namespace limn
