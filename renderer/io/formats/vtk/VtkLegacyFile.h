// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"
#include "io/reading/Progress.h"
#include "io/reading/VoxelKeeping.h"

#include <filesystem>
#include <string_view>

namespace limn {

/// Whether the bytes start as a legacy VTK file does.
bool isVtkLegacy(std::string_view bytes);

/// Reads the first scalars of a legacy VTK file of STRUCTURED_POINTS, binary or text. Its axes say nothing
/// of the patient: the orientation is unknown. Throws Error; Cancelled.
/// Source: VTK User's Guide, "Simple Legacy Formats".
VolumeParts readVtkLegacy(const std::filesystem::path& path, const VoxelKeeping& keeping,
                          const Progress& progress);

} // namespace limn
