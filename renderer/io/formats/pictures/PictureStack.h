// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"
#include "io/reading/Progress.h"
#include "scene/basics/MemoryBudget.h"

#include <filesystem>
#include <string_view>
#include <vector>

namespace limn {

/// Whether the bytes start as a TIFF, PNG or JPEG picture does.
bool isPicture(std::string_view bytes);

/// The pictures of a folder (not of its subfolders), in the order of the numbers in their names: 2 before 10.
std::vector<std::filesystem::path> picturesIn(const std::filesystem::path& folder);

/// Throws Error where a file of the folder is called as its pictures are, but is none: a lost slice.
void requireWholeStack(const std::filesystem::path& folder,
                       const std::vector<std::filesystem::path>& pictures);

/// Whether `a` comes before `b` when runs of digits count as numbers.
bool naturalLess(std::string_view a, std::string_view b);

/// Reads a stack of pictures, one slice each in the order given, or the pages of one file. All must have one
/// size and type; colours become luminance with a warning. Pictures say nothing of spacing along the stack
/// or of orientation: both are unknown. Throws Error; Cancelled.
VolumeParts readPictures(const std::filesystem::path& path, const std::vector<std::filesystem::path>& files,
                         const MemoryBudget& budget, const Progress& progress);

} // namespace limn
