// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/properties/FogFit.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double leftAtFarEnd = 0.2;

// A number of two digits reads better than one of sixteen.
double rounded(double number) {
  if (!(number > 0.0))
    return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1.0);
  return std::round(number / unit) * unit;
}

} // namespace

DepthRange depthRange(const Camera& camera, const Grid& grid) {
  const CameraBasis basis = basisOf(camera);
  DepthRange range{1e300, 0.0};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 side(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::dvec3 place = boxCentreMm(grid) + grid.direction * ((side - 0.5) * boxSizeMm(grid));
    const double depth = std::max(0.0, glm::dot(place - camera.position, basis.forward));
    range.nearMm = std::min(range.nearMm, depth);
    range.farMm = std::max(range.farMm, depth);
  }
  return range;
}

Fog withFogMode(const Scene& scene, Fog::Mode mode) {
  const Fog initial;
  Fog fog = scene.fog;
  fog.mode = mode;
  if (mode == Fog::Mode::none || !scene.volume)
    return fog;
  const DepthRange depth = depthRange(scene.camera, scene.volume->grid());
  const bool untouched =
      fog.startMm == initial.startMm && fog.endMm == initial.endMm && fog.densityPerMm == 0.0;
  if (untouched) {
    fog.startMm = std::round(depth.nearMm);
    // F = (end - z)/(end - start) is a fifth at the far end.
    fog.endMm = std::round(depth.nearMm + (depth.farMm - depth.nearMm) / (1.0 - leftAtFarEnd));
    if (fog.color == initial.color)
      fog.color = scene.image.background;
  }
  const double length = std::max(1.0, depth.farMm - fog.startMm);
  // exp(-ρ·d) and exp(-(ρ·d)²) are a fifth at the far end.
  const double exponent = -std::log(leftAtFarEnd);
  if (fog.densityPerMm == 0.0 && mode == Fog::Mode::exp)
    fog.densityPerMm = rounded(exponent / length);
  if (fog.densityPerMm == 0.0 && mode == Fog::Mode::exp2)
    fog.densityPerMm = rounded(std::sqrt(exponent) / length);
  return fog;
}

} // namespace limn
