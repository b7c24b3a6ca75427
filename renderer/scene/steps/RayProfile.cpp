// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/RayProfile.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace limn {
namespace {

// Half an 8-bit level of the pixel.
constexpr double leastAlpha = 1.0 / 510.0;

// Whether one place of the ray is seen rather than another.
bool hasPlace(const RayProfile& profile) {
  return profile.projection != Projection::average && profile.alpha >= leastAlpha;
}

} // namespace

glm::dvec3 placeAt(const RayProfile& profile, double depthMm) {
  return profile.entryMm + depthMm * profile.direction;
}

const RayProfile::Sample& sampleAt(const RayProfile& profile, double depthMm) {
  assert(!profile.samples.empty());
  const auto distance = [depthMm](const RayProfile::Sample& sample) {
    return std::abs(sample.depthMm - depthMm);
  };
  const auto behind = std::ranges::lower_bound(profile.samples, depthMm, {}, &RayProfile::Sample::depthMm);
  if (behind == profile.samples.begin())
    return *behind;
  const auto before = std::prev(behind);
  return behind == profile.samples.end() || distance(*before) <= distance(*behind) ? *before : *behind;
}

std::optional<double> halfLightDepth(const RayProfile& profile) {
  if (!hasPlace(profile))
    return std::nullopt;
  double before = 0.0;
  for (const RayProfile::Sample& sample : profile.samples) {
    const double missing = 0.5 * profile.alpha - before;
    if (sample.contribution > 0.0 && sample.contribution >= missing)
      return sample.depthMm + (missing / sample.contribution - 0.5) * sample.lengthMm;
    before += sample.contribution;
  }
  return std::nullopt;
}

std::optional<double> strongestDepth(const RayProfile& profile) {
  const auto strongest = std::ranges::max_element(profile.samples, {}, &RayProfile::Sample::contribution);
  if (!hasPlace(profile) || strongest == profile.samples.end())
    return std::nullopt;
  return strongest->depthMm;
}

bool gathersLight(Projection projection) {
  return projection == Projection::composite || projection == Projection::xray ||
         projection == Projection::compositeIsosurface;
}

} // namespace limn
