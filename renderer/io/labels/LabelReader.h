// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/Progress.h"
#include "scene/regions/Region.h"
#include "scene/volume/Volume.h"

#include <filesystem>

namespace limn {

/// Reads a label map: a DICOM segmentation, or a volume of whole numbers in any format that readVolume reads.
/// It comes on `grid`, nearest label by nearest label where it has another one, with the names and colours
/// that the file gives (DICOM segments, Slicer's segmentations in NRRD). Every label weighs 1. Throws Error
/// (input) with one sentence naming the file; Cancelled.
Region readLabels(const std::filesystem::path& path, const Grid& grid, const Progress& progress = {});

} // namespace limn
