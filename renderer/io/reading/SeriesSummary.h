// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <optional>
#include <string>

namespace limn {

/// One series of a DICOM folder, without what names the patient.
struct SeriesSummary {
  int number = 0; ///< 1, 2, … in the order listed; what `--series` takes
  std::string description;
  std::string modality;
  glm::ivec3 dims{0};                ///< columns, rows, images
  std::optional<double> thicknessMm; ///< of a slice, where the file says
  std::string date;                  ///< of the study, "2024-05-31"; empty where the file says nothing
  std::string folder;                ///< of its files below the folder listed, empty where they lie in it
};

} // namespace limn
