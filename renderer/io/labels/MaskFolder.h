// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/labels/LabelReader.h"

#include <filesystem>
#include <vector>

namespace limn {

/// Whether a path is a folder with volume files in it, as segmentations have that are written with one mask a
/// structure (TotalSegmentator's `segmentations`). What the files hold is not looked at. Never throws.
bool isMaskFolder(const std::filesystem::path& path);

/// Reads the masks of such a folder as one label map, called after their files (LabelNames.h). The value of a
/// label is the number of its file among the folder's volume files by name, from 1 on; of two
/// masks with a voxel in common the later by name has it. Throws as readLabels does.
Segmentation readMaskFolder(const std::filesystem::path& folder, const Grid& grid,
                            const Progress& progress = {}, const PatientLabel& patient = {});

/// Reads masks in several files as one label map, as those of a folder, but that a name and a colour which
/// the file itself gives its only label (LabelReader.h) stay. The value of a label is the number of its file
/// in the list, from 1 on, without those that are no masks; of two masks with a voxel in common the later has
/// it. Where one alone is a mask it is read as by itself. Throws as readLabels does.
Segmentation readMasks(const std::vector<std::filesystem::path>& files, const Grid& grid,
                       const Progress& progress = {}, const PatientLabel& patient = {});

/// Whether the labels of a region that is not cut are masks that others can come to: of a file each, a volume
/// by its ending or a DICOM segmentation.
bool isOfMasks(const Region& region);

/// Masks that are open and masks that come to them, both isOfMasks on `grid`, as the region that readMasks
/// makes of their files, without reading any. What was open is shown as it was, also where it was opened once
/// more, by which it becomes the last; the rest weighs 1. But voxels that one took from others when it came
/// first do not come back to those where its file has them no more. The remark is on voxels that the later
/// take, and on those that are nobody's for that.
/// Throws Cancelled.
Segmentation joinedMasks(const Region& open, const Region& opened, const Grid& grid,
                         const Progress& progress = {}, const PatientLabel& patient = {},
                         std::shared_ptr<Room> room = {});

} // namespace limn
