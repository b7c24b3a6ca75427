// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/dicom/DicomVoxels.h"
#include "io/dicom/series/DicomGeometry.h"

namespace limn {

/// Resamples slices onto the grid of `geometry`: each shifted in its plane (bilinear), planes between two of
/// them mixed linearly. Where one of the voxels to mix is padding, the nearest is taken instead; what no
/// slice covers becomes padding, for which a value that no voxel has is declared where none was (the type is
/// widened if all are in use). Integers are rounded. Throws Cancelled.
DicomVoxels resampled(DicomVoxels voxels, const glm::ivec3& sourceDims, const DicomGeometry& geometry,
                      const Progress& progress);

} // namespace limn
