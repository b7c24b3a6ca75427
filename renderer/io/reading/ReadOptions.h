// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/MemoryBudget.h"

#include <glm/glm.hpp>

#include <memory>
#include <optional>
#include <string>

namespace limn {

struct PartWanted; // io/reading/PartWanted.h

/// What the person who opens a file adds to it.
struct ReadOptions {
  std::optional<glm::dvec3> spacingMm; ///< for image stacks and files without spacing; overrides otherwise
  std::optional<int> series;           ///< number of a series as DicomFolder gives it
  std::optional<MemoryBudget> memory;  ///< how much of it the process may take (default: MemoryBudget's)
  /// Where this is one of several processes that hold a volume together. A DICOM series that must be
  /// straightened is held whole by each nevertheless; its remarks say so.
  std::shared_ptr<const PartWanted> part;
};

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
