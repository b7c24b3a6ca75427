// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"
#include "widgets/properties/CropFaces.h"

#include <QString>

namespace limn {

/// What a face of the crop box is called: an anatomical side, or an end of a voxel axis where the orientation
/// is unknown.
QString cropFaceName(const Volume& volume, CropFace face);

} // namespace limn
