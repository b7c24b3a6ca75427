// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"
#include "widgets/properties/CropFaces.h"

#include <QString>

#include <array>

namespace limn {

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

} // namespace limn
