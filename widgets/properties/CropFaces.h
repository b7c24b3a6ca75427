// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <QString>

#include <array>

namespace limn {

/// One of the six faces of the crop box.
struct CropFace {
  int axis = 0; ///< of the grid
  bool isUpper = false;
  bool operator==(const CropFace&) const = default;
};

inline constexpr std::array<CropFace, 6> cropFaces{
    {{0, false}, {0, true}, {1, false}, {1, true}, {2, false}, {2, true}}};

/// Where a face lies, as a fraction along its axis.
double placeOf(const CropBox& crop, CropFace face);

/// The box with one face moved. It stays inside the volume and stops one voxel before the opposite face, so
/// that something is always left.
CropBox withFaceAt(const CropBox& crop, const Grid& grid, CropFace face, double fraction);

/// The box around a body that is kept, a voxel wider on each side; the whole volume where no body is known.
CropBox boxAroundBody(const Scene& scene);

/// The share of the volume that the box leaves, 0..1.
double shareLeft(const CropBox& crop);

/// The voxels along one axis whose centres lie inside the box, counted from 1.
struct VoxelSpan {
  int first = 1;
  int last = 1; ///< less than `first` where the box lies between two centres
  bool operator==(const VoxelSpan&) const = default;
};

/// `axis` is 0, 1 or 2 of the grid.
VoxelSpan voxelsInside(const CropBox& crop, const Grid& grid, int axis);

/// A crop box whose faces do not follow the volume: the part `crop` of a box of its own around it, which is
/// told as a grid (its axes are the faces' normals, its voxels the least that a face leaves).
struct TurnedBox {
  Grid grid;
  CropBox crop;
  CropBox fit{}; ///< of the whole what is seen fills: a face there, or farther out, cuts nothing
  bool operator==(const TurnedBox&) const = default;
};

/// How much of what is seen a face takes away, as a fraction along its axis of the whole box, >= 0.
double cutBy(const TurnedBox& box, CropFace face);

/// What a clinician calls an axis of the voxel grid: by the patient's directions where they are known, by
/// what is stacked along it where not.
struct AxisName {
  QString axis;    ///< "Right–Left", in the order of the indices; "Columns"
  QString lowEnd;  ///< "Right"; "first"
  QString highEnd; ///< "Left"; "last"
};

/// The names of the three grid axes. Each direction of the patient is used once: an oblique grid's axes go to
/// the directions that they follow best together.
std::array<AxisName, 3> axisNames(const Grid& grid, bool orientationKnown);

/// What a face of the crop box is called: an anatomical side, or an end of a voxel axis where the orientation
/// is unknown.
QString cropFaceName(const Volume& volume, CropFace face);

/// What a face of a box that is turned is called, within a sentence: by the side of the patient that it
/// follows best or, where the orientation is unknown, by where it lay as the box was turned to the view.
QString turnedFaceName(const TurnedBox& box, const Volume& volume, CropFace face);

} // namespace limn
