// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/Resolution.h"

#include "scene/ProjectionFacts.h"
#include "scene/function/FunctionDetail.h"
#include "scene/steps/RayFrame.h"

namespace limn {

bool stepSeesFunction(const Scene& scene, double steepestPerMm, bool isPreintegrated) {
  if (isPreintegrated || !integrates(scene.projection))
    return true;
  const double perStep = steepestPerMm * stepMm(scene);
  const TransferFunction function =
      overVoxelAtLeast(scene.transferFunction, smallestSpacingMm(scene.volume->grid()));
  return narrowestVisibleBand(function, leastBandHeight, scene.volume->range()) >= perStep;
}

} // namespace limn
