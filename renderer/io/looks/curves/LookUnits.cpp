// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/LookUnits.h"

#include "io/looks/curves/CurvedSegments.h"
#include "io/looks/curves/LookCurves.h"
#include "io/looks/text/LookText.h"
#include "scene/ProjectionFacts.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

constexpr double highestByte = 255.0; // where such programs end a curve that does nothing

// Gradients are not negative: the curve from 0 on.
std::vector<GradientOpacityPoint> fromZero(const std::vector<ControlPoint>& curve) {
  std::vector<GradientOpacityPoint> points;
  const bool startsBelow = curve.front().value < 0.0;
  if (startsBelow)
    points.push_back({0.0, classify({1.0, curve}, 0.0).opacity});
  for (const ControlPoint& point : curve)
    if (point.value > 0.0 || (point.value == 0.0 && !startsBelow))
      points.push_back({point.value, point.opacity});
  return points;
}

bool isConstant(const std::vector<GradientOpacityPoint>& points) {
  return std::all_of(points.begin(), points.end(), [&](const GradientOpacityPoint& point) {
    return point.opacity == points.front().opacity;
  });
}

double spacingFor(const std::optional<LookTarget>& target, std::vector<Message>& changes) {
  if (target)
    tell(changes, Message::tr("Gradient opacity was converted between value per voxel and value per mm for "
                              "voxels of %1 mm.")
                      .arg(Message::rounded(target->meanSpacingMm, 4)));
  else
    tell(changes,
         Message::tr("Gradient opacity was converted between value per voxel and value per mm for voxels "
                     "of 1 mm; name the volume for which the look is meant (--for) to have its own."));
  return target ? target->meanSpacingMm : 1.0;
}

Message rangeText(double low, double high) {
  return Message::tr("%1 to %2").arg(Message::rounded(low, 6), Message::rounded(high, 6));
}

} // namespace

std::optional<GradientOpacity> gradientOpacityFromVtk(const std::vector<ControlPoint>& curve,
                                                      const std::optional<LookTarget>& target,
                                                      std::vector<Message>& changes) {
  GradientOpacity opacity{fromZero(curve)};
  if (isConstant(opacity.points)) {
    if (opacity.points.front().opacity == 1.0)
      return std::nullopt;
    return opacity;
  }
  const double spacing = spacingFor(target, changes);
  for (GradientOpacityPoint& point : opacity.points)
    point.gradient /= spacing;
  return opacity;
}

std::vector<GradientOpacityPoint> gradientOpacityForVtk(const std::optional<GradientOpacity>& opacity,
                                                        const std::optional<LookTarget>& target,
                                                        std::vector<Message>& changes) {
  if (!opacity || opacity->points.empty())
    return {{0.0, 1.0}, {highestByte, 1.0}};
  std::vector<GradientOpacityPoint> points = opacity->points;
  if (isConstant(points))
    return points;
  const double spacing = spacingFor(target, changes);
  for (GradientOpacityPoint& point : points)
    point.gradient *= spacing;
  return points;
}

TransferFunction stretchedOver(const TransferFunction& function, const std::optional<LookTarget>& target,
                               std::vector<Message>& changes) {
  if (!target) {
    tell(changes,
         Message::tr("Its values are relative, from 0 to 1, and stay so; name the volume for which the "
                     "look is meant (--for) to stretch them over its range."));
    return function;
  }
  TransferFunction stretched = function;
  for (ControlPoint& point : stretched.points)
    point.value = target->low + point.value * (target->high - target->low);
  tell(changes, Message::tr("Its values from 0 to 1 were stretched over %1.")
                    .arg(rangeText(target->low, target->high)));
  return stretched;
}

TransferFunction overOneMillimetre(const TransferFunction& function, std::vector<Message>& changes) {
  if (function.unitDistanceMm == 1.0 || function.points.empty())
    return function;
  const auto rescaled = [&](double opacity) {
    return opacity < 1.0 ? -std::expm1(std::log1p(-opacity) / function.unitDistanceMm) : 1.0;
  };
  constexpr int looks = 64;
  std::vector<ControlPoint> seen;
  for (std::size_t i = 0; i < function.points.size(); ++i) {
    const ControlPoint& from = function.points[i];
    seen.push_back({from.value, from.color, rescaled(from.opacity)});
    if (i + 1 == function.points.size() || function.points[i + 1].opacity == from.opacity)
      continue;
    const ControlPoint& to = function.points[i + 1];
    for (int k = 1; k < looks; ++k) {
      const double u = k / double(looks);
      const ControlPoint between{std::lerp(from.value, to.value, u), glm::mix(from.color, to.color, u),
                                 rescaled(std::lerp(from.opacity, to.opacity, u))};
      if (between.value > seen.back().value && between.value < to.value)
        seen.push_back(between);
    }
  }
  tell(changes,
       Message::tr("Opacities over %1 mm became those over 1 mm, within %2.")
           .arg(Message::rounded(function.unitDistanceMm, 4), Message::rounded(segmentTolerance, 2)));
  return {1.0, simplified(seen, 0.8 * segmentTolerance)};
}

void tellLostParts(const Preset& preset, std::vector<Message>& changes) {
  if (preset.projection && *preset.projection != Projection::composite)
    tell(changes, Message::tr("The projection \"%1\" was left out.").arg(nameOf(*preset.projection)));
  if (preset.landmarks)
    tell(changes, Message::tr("How the look moves to data of another scale was left out."));
}

} // namespace limn
