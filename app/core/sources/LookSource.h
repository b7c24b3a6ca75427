// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/core/sources/SceneSource.h"
#include "io/looks/dicom/DicomLook.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace limn {

/// A DICOM look and the series that it belongs to.
struct PlacedLook {
  DicomLook look;
  std::shared_ptr<const DicomFolder> dicom; ///< that holds the series
  int series = 1;                           ///< its number there
};

/// Reads a look and finds its series: where the options say, else in the look's own folder, else in one that
/// was opened before. Throws VolumeMissing where it is nowhere; Error (input) where the place that was named
/// holds another series or not all of the images; Cancelled.
PlacedLook placedLook(const std::filesystem::path& file, const SourceOptions& options,
                      const Progress& progress);

/// The DICOM looks in the folder that was opened, or in that of the file, and below it, whose images are all
/// of one series; newest file first. What cannot be read is none. Throws Error (input) where the folder of
/// the file cannot be read; Cancelled.
std::vector<std::filesystem::path> looksBeside(const DicomFolder& dicom, std::optional<int> series,
                                               const Progress& progress);

} // namespace limn
