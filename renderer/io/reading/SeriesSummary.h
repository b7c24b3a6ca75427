// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <string>

namespace limn {

/// One series of a DICOM folder, without patient data.
struct SeriesSummary {
  int number = 0; ///< 1, 2, … in the order listed; what `--series` takes
  std::string description;
  std::string modality;
  glm::ivec3 dims{0}; ///< columns, rows, images
  std::string folder; ///< of its files below the folder listed, empty where they lie in it
};

} // namespace limn
