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

/// Whether a file holds DICOM (with or without the preamble), or a folder holds at least one such file.
/// Looks at content, never at names; cheap (a few hundred bytes per file, stops at the first).
bool isDicom(const std::filesystem::path& path);

/// The DICOM part of readVolume: same contract.
std::shared_ptr<const Volume> readDicom(const std::filesystem::path& path, const ReadOptions& options,
                                        const Progress& progress);

/// The DICOM part of listSeries: same contract.
std::vector<SeriesSummary> listDicomSeries(const std::filesystem::path& path);

} // namespace limn
