// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/series/DicomSeries.h"

namespace limn {

/// Where an acquired slice lies against the grid: its height along the normal above the grid's first plane
/// (mm), and how far its first pixel is shifted in the plane from the grid's (pixels, x along rows).
struct DicomPlacement {
  double heightMm = 0.0;
  glm::dvec2 shift{0.0};
};

/// The orthonormal grid that represents a series.
struct DicomGeometry {
  Grid grid;
  bool orientationKnown = true;
  bool spacingKnown = true;
  bool needsResampling = false; ///< the slices do not lie on the grid as they are
  bool slants = false;          ///< the first warning says by how much, and that resampling made it upright
  std::vector<DicomPlacement> placements; ///< one per slice; used where resampling is needed
};

/// Finds the grid of a sorted series with one slice per position. Slices in line at equal distances (within
/// 5 % of the median, averaged with a warning where they differ measurably) lie on it as they are; tilted,
/// sideways shifted and unequally spaced ones need resampling, which a warning states. Without positions the
/// slices are stacked, orientation unknown, with a warning. A
/// spacing that nobody states is 1 mm, with a warning unless the caller gives one.
/// Throws Error (input) where a gap is too large to bridge or the slices form no stack.
DicomGeometry geometryOf(const DicomSeries& series, bool spacingIsGiven, std::vector<Message>& warnings);

} // namespace limn
