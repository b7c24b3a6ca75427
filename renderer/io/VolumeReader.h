// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/Progress.h"
#include "io/reading/ReadOptions.h"
#include "scene/volume/Volume.h"

#include <filesystem>
#include <memory>

namespace limn {

class DicomFolder;

/// What openDicom gives, with sentences as those of readVolume: null where `path` is not DICOM.
std::shared_ptr<const DicomFolder> dicomAt(const std::filesystem::path& path, const Progress& progress);

/// Reads any supported volume: DICOM folder or file, NIfTI, NRRD, MetaImage, VTI, legacy VTK, a stack of
/// TIFF/PNG/JPEG (folder or multi-page file), InVesalius project. Safe on a worker thread.
/// Throws Error (input) with one sentence naming the file, the reason and a way out; Cancelled when asked to
/// stop.
std::shared_ptr<const Volume> readVolume(const std::filesystem::path& path, const ReadOptions& options = {},
                                         const Progress& progress = {});

/// The same for a path of which dicomAt has told whether it is DICOM: no header is read again.
std::shared_ptr<const Volume> readVolume(const std::filesystem::path& path,
                                         const std::shared_ptr<const DicomFolder>& dicom,
                                         const ReadOptions& options, const Progress& progress);

/// Throws Error (input), naming `path`, where voxels of the volume that was read from there were lost since:
/// its file became shorter, or its disk failed. To be asked before what was made of them is shown or written.
void requireWhole(const std::filesystem::path& path, const Volume& volume);

} // namespace limn
