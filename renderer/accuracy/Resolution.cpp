// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/Resolution.h"

#include "scene/FunctionDetail.h"
#include "scene/RayFrame.h"

namespace limn {
namespace {

bool classifiesSamples(Projection projection) {
  return projection == Projection::composite || projection == Projection::xray ||
         projection == Projection::compositeIsosurface;
}

} // namespace

bool stepSeesFunction(const Scene& scene, double steepestPerMm, bool isPreintegrated) {
  if (isPreintegrated || !classifiesSamples(scene.projection))
    return true;
  const double perStep = steepestPerMm * stepMm(scene);
  const TransferFunction function =
      overVoxelAtLeast(scene.transferFunction, smallestSpacingMm(scene.volume->grid()));
  return narrowestVisibleBand(function, leastBandHeight, scene.volume->range()) >= perStep;
}

} // namespace limn
