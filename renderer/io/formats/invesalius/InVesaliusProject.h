// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"
#include "io/reading/Progress.h"
#include "io/reading/VoxelKeeping.h"

#include <filesystem>
#include <string_view>

namespace limn {

/// Whether the bytes (inflated) start as a tar archive does.
bool isTar(std::string_view bytes);

/// Reads the volume of an InVesalius 3 project (.inv3): a tar archive, usually gzipped, with main.plist and
/// the matrix it names, stored slice by slice from the feet up, rows from back to front, columns from the
/// patient's right to left. The format has no origin: the volume is centred on the world's. Projects whose
/// slices were not axial, or that were made from a NIfTI file, open with the orientation unknown.
/// Throws Error; Cancelled.
VolumeParts readInVesalius(const std::filesystem::path& path, const VoxelKeeping& keeping,
                           const Progress& progress);

} // namespace limn
