// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/SceneSource.h"
#include "io/looks/dicom/DicomLook.h"

#include <filesystem>

namespace limn {

/// A DICOM look and the series that it belongs to.
struct PlacedLook {
  DicomLook look;
  std::filesystem::path folder; ///< of the series, as readVolume takes it
  int series = 1;               ///< its number there
};

/// Reads a look and finds its series: where the options say, else in the look's own folder, else in one that
/// was opened before. Throws VolumeMissing where it is nowhere; Error (input) where the place that was named
/// holds another series or not all of the images; Cancelled.
PlacedLook placedLook(const std::filesystem::path& file, const SourceOptions& options,
                      const Progress& progress);

} // namespace limn
