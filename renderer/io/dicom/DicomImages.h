// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/reading/Progress.h"

#include <filesystem>
#include <string>
#include <vector>

namespace limn {

/// An image by what other objects call it.
struct DicomReference {
  std::string sopClass;
  std::string sopInstance;
  auto operator<=>(const DicomReference&) const = default;
};

/// The images that the volume of a series is made of.
struct SeriesImages {
  int number = 0; ///< as listSeries gives it
  std::string study;
  std::string series;
  std::vector<DicomReference> images; ///< each once, in the order of the slices
  std::filesystem::path firstFile;    ///< the file of the first of them
  /// Instances of the series that the volume is not made of: other phases.
  std::vector<std::string> leftOut = {};
};

/// The series under a path, in the order of listSeries, each without copies and with the images of the phase
/// that is shown. Empty where there is no DICOM. Throws Error (input); Cancelled.
std::vector<SeriesImages> imagesUnder(const std::filesystem::path& path, const Progress& progress);

} // namespace limn
