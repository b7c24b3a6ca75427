// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"
#include "io/reading/Progress.h"
#include "io/reading/VoxelKeeping.h"

#include <filesystem>
#include <string_view>

namespace limn {

/// Whether the bytes start as a MetaImage header does: lines "Key = Value", NDims among them.
bool isMetaImage(std::string_view bytes);

/// Reads a MetaImage volume, attached (.mha) or detached (.mhd), plain or zlib-compressed. The orientation
/// counts as known where the header has a TransformMatrix and does not declare it meaningless ("???").
/// Throws Error; Cancelled. Source: itk.org/Wiki/ITK/MetaIO/Documentation; directions and offset are in LPS
/// as ITK writes them.
VolumeParts readMetaImage(const std::filesystem::path& path, const VoxelKeeping& keeping,
                          const Progress& progress);

} // namespace limn
