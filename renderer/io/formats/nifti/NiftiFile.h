// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"
#include "io/reading/Progress.h"
#include "io/reading/VoxelKeeping.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace limn {

/// Whether the bytes start as a NIfTI header does, or as one of Analyze, its ancestor, whose refusal says
/// more.
bool isNifti(std::string_view bytes);

/// What stands in the extensions of a single-file NIfTI between its header and its voxels (nifti1.h,
/// "EXTENDED HEADER"), each as the bytes that it has, whatever its code; of a file that lies or ends early
/// those before that. None of another file. Throws Error where the file cannot be opened.
std::vector<std::string> niftiExtensions(const std::filesystem::path& path);

/// Reads a NIfTI-1 or NIfTI-2 volume from its header file (.nii, .nii.gz, .hdr, .hdr.gz) or voxel file
/// (.img, .img.gz). Of several volumes the first is read, with a warning.
VolumeParts readNifti(const std::filesystem::path& path, const VoxelKeeping& keeping,
                      const Progress& progress);

} // namespace limn
