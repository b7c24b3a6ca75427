// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/looks/curves/PointLook.h"

#include "io/looks/curves/LookCurves.h"
#include "io/looks/curves/LookUnits.h"

#include <algorithm>
#include <cmath>

namespace limn {

std::vector<ReadLook> finished(PointLook look, const std::string& file,
                               const std::optional<LookTarget>& target) {
  ReadLook read{{}, std::move(look.changes)};
  read.preset.name = lookNameOf(file);
  TransferFunction function{1.0, checkedCurve(std::move(look.points), file, read.changes)};
  if (look.isRelative) {
    function = stretchedOver(function, target, read.changes);
    function.points = checkedCurve(std::move(function.points), file, read.changes); // huge ones no longer are
  }
  read.preset.transferFunction = std::move(function);
  return {std::move(read)};
}

TransferFunction pointsAlone(const Preset& preset, std::vector<Message>& changes) {
  tellLostParts(preset, changes);
  if (preset.shading)
    tell(changes, Message::tr("Light and material were left out: the format has no place for them."));
  if (preset.gradientOpacity)
    tell(changes, Message::tr("The opacity by gradient was left out: the format has no place for it."));
  TransferFunction function = overOneMillimetre(preset.transferFunction, changes);
  if (function.points.empty())
    function.points.push_back({}); // transparent
  return function;
}

std::vector<ControlPoint> maskedTo(const std::vector<ControlPoint>& points, double low, double high) {
  const auto end = [&](double value, bool isClear) {
    const Classified seen = classify({1.0, points}, value);
    return ControlPoint{value, seen.color, isClear ? 0.0 : seen.opacity};
  };
  std::vector<ControlPoint> masked;
  if (std::isfinite(low))
    masked = {end(low, true), end(low, false)};
  for (const ControlPoint& point : points)
    if (point.value > low && point.value < high)
      masked.push_back(point);
  if (!std::isfinite(high))
    return masked;
  const auto atEnd = std::ranges::lower_bound(points, high, {}, &ControlPoint::value);
  const bool hasPoint = atEnd != points.end() && atEnd->value == high; // the first one, before any step there
  masked.push_back(hasPoint ? *atEnd : end(high, false));
  masked.push_back(masked.back());
  masked.back().opacity = 0.0;
  return masked;
}

} // namespace limn
