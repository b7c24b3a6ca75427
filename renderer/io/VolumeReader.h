// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/Progress.h"
#include "io/reading/ReadOptions.h"
#include "io/reading/SeriesSummary.h"
#include "scene/volume/Volume.h"

#include <filesystem>
#include <memory>
#include <vector>

namespace limn {

/// The series in a DICOM folder (or file), largest first; empty where `path` is not DICOM.
std::vector<SeriesSummary> listSeries(const std::filesystem::path& path);

/// Reads any supported volume: DICOM folder or file, NIfTI, NRRD, MetaImage, VTI, legacy VTK, a stack of
/// TIFF/PNG/JPEG (folder or multi-page file), InVesalius project. Safe on a worker thread.
/// Throws Error (input) with one sentence naming the file, the reason and a way out; Cancelled when asked to
/// stop.
std::shared_ptr<const Volume> readVolume(const std::filesystem::path& path, const ReadOptions& options = {},
                                         const Progress& progress = {});

/// Throws Error (input), naming `path`, where voxels of the volume that was read from there were lost since:
/// its file became shorter, or its disk failed. To be asked before what was made of them is shown or written.
void requireWhole(const std::filesystem::path& path, const Volume& volume);

} // namespace limn
