// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"
#include "io/reading/Progress.h"
#include "io/reading/VoxelKeeping.h"

#include <filesystem>
#include <string_view>

namespace limn {

/// Whether the bytes start as a VTK XML file of any data set does.
bool isVtkXml(std::string_view bytes);

/// Reads the active scalars of VTK image data (.vti) of one piece: text, base64 or raw, plain or compressed
/// by zlib. Its axes say nothing of the patient: the orientation is unknown. Throws Error; Cancelled.
VolumeParts readVtkXml(const std::filesystem::path& path, const VoxelKeeping& keeping,
                       const Progress& progress);

} // namespace limn
