// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"
#include "io/reading/Progress.h"
#include "scene/basics/MemoryBudget.h"

#include <filesystem>
#include <string_view>

namespace limn {

/// Whether the bytes start as a NIfTI header does, or as one of Analyze, its ancestor, whose refusal says
/// more.
bool isNifti(std::string_view bytes);

/// Reads a NIfTI-1 or NIfTI-2 volume from its header file (.nii, .nii.gz, .hdr, .hdr.gz) or voxel file
/// (.img, .img.gz). Of several volumes the first is read, with a warning.
VolumeParts readNifti(const std::filesystem::path& path, const MemoryBudget& budget,
                      const Progress& progress);

} // namespace limn
