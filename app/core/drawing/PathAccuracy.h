// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/AccuracySweep.h"
#include "scene/basics/Effort.h"

#include <optional>

namespace limn {

/// Error against time of a scene in physical light, as one picture gets twice and twice as many paths, from 4
/// to `mostPathsMeasured` of each pixel. Errors are the standard errors of the display colours, of which no
/// exact picture need be known; times are those of the whole picture until then. Remarks tell the law found
/// (accuracy/sweep/FigureText). Throws Error, also where the memory that is free does not hold what paths
/// find; Cancelled.
AccuracyReport measurePaths(const std::string& name, const Scene& scene, const glm::ivec2& size,
                            int mostPathsMeasured, const Effort& effort, const ReportProgress& progress = {});

/// Of a picture of physical light with as many paths as its scene asks for, how far each pixel may be off.
struct PathErrors {
  std::optional<ImageError>
      error;    ///< over the colours of all covered pixels; not known of fewer than 2 paths
  ErrorMap map; ///< of each pixel that of the worst colour
};
/// Throws Error, also where the memory that is free does not hold what paths find; Cancelled.
PathErrors pathErrors(const Scene& scene, const glm::ivec2& size, const Effort& effort,
                      const ReportProgress& progress = {});

} // namespace limn
