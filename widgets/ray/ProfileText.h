// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/steps/RayProfile.h"

#include <QString>

#include <array>
#include <vector>

namespace limn {

/// How depths and values of a volume are called.
struct ProfileNames {
  QString valueUnit;             ///< "HU", or empty
  QString depthUnit;             ///< "mm"; empty where the file tells no lengths
  int valueDecimals = 0;         ///< ≥ 0
  std::vector<QString> labels{}; ///< of each sample; none where no segmentation is open
  bool operator==(const ProfileNames&) const = default;
};

/// What a ray shows, in one or two sentences: where half of its light comes from, and of how much; of
/// projections that gather no light, what they show instead.
QString profileSummary(const RayProfile& profile, const ProfileNames& names);

/// What lies at a depth: "34.2 mm: 310 HU, Liver, opacity 0.34/mm, 48 % of the light so far".
QString readingAt(const RayProfile& profile, const ProfileNames& names, double depthMm);

/// What each lane shows, and the most that it shows of it: value, opacity, contribution.
struct LaneText {
  QString title;
  QString range;
};
std::array<LaneText, 3> laneTexts(const RayProfile& profile, const ProfileNames& names);

/// The share of the pixel per millimetre of a piece, 0..1 and above; of a surface, which has no length, all
/// of it.
double contributionPerMm(const RayProfile::Sample& sample);

/// The smallest and the largest value along a ray; there are samples.
ValueRange valuesOf(const RayProfile& profile);

} // namespace limn
