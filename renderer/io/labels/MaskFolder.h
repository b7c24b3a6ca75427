// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/labels/LabelReader.h"

namespace limn {

/// Whether a path is a folder with volume files in it, as segmentations have that are written with one mask a
/// structure (TotalSegmentator's `segmentations`). What the files hold is not looked at. Never throws.
bool isMaskFolder(const std::filesystem::path& path);

/// Reads the masks of such a folder as one label map, called after their files (LabelNames.h). The value of a
/// label is the number of its file among the folder's volume files by name, from 1 on; of two
/// masks with a voxel in common the later by name has it. Throws as readLabels does.
Segmentation readMaskFolder(const std::filesystem::path& folder, const Grid& grid,
                            const Progress& progress = {}, const PatientLabel& patient = {});

} // namespace limn
