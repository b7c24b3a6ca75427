// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/formats/voxels/Voxels.h"
#include "io/reading/Progress.h"
#include "scene/basics/MemoryBudget.h"

#include <filesystem>

namespace limn {

/// Reads a NRRD volume, attached (.nrrd) or detached (.nhdr), raw, gzip or text. Three spatial axes (two
/// make one slice), before them at most an axis of colours, after them further volumes of which the first
/// is read with a warning. Throws Error; Cancelled.
VolumeParts readNrrd(const std::filesystem::path& path, const MemoryBudget& budget, const Progress& progress);

} // namespace limn
