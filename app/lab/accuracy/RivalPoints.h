// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "accuracy/sweep/AccuracySweep.h"
#include "accuracy/sweep/ConvergedPicture.h"

#include <string>
#include <vector>

namespace limn {

/// How VTK's mappers, in processes of their own, come to the volume of a scene.
struct RivalSource {
  std::string volumePath;
  std::vector<std::string> readOptions; ///< as on the command line
};

/// Adds VTK's two mappers to a report, at steps of 2, 1, 1/2 and 1/4 voxel: the median, least and most of
/// `frames` pictures on the clock, drawn behind Limn's own, not in turns with them, which a remark says. They
/// light surfaces from both sides, so `exact` is the converged picture of the scene lit so. Their pictures
/// are 8 bits over the background: rounding adds up to half a level, and alpha counts as right. A mapper
/// that cannot be had or refuses the scene gets a remark. `scene.image` has the report's size. Throws
/// Cancelled.
void addRivals(AccuracyReport& report, const Scene& scene, const RivalSource& source,
               const PrecisePixels& exact, int frames, const ReportProgress& progress = {});

} // namespace limn
