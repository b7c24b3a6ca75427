// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/Look.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace limn {

/// Between two colours of a curve: straight in sRGB; straight in hue, saturation and value; straight in CIE
/// L*a*b* (D65); through white in Msh (K. Moreland, "Diverging color maps for scientific visualization",
/// ISVC 2009); or the second one throughout.
enum class ColorSpace { rgb, hsv, wrappedHsv, lab, diverging, step };

/// The colour a fraction `u` of the way from one to another. Of hsv, hues go the way round that avoids red's
/// end of the circle; of wrappedHsv, the shorter one. All colours are sRGB-encoded, 0..1.
glm::dvec3 mixed(ColorSpace space, const glm::dvec3& from, const glm::dvec3& to, double u);

/// A control point of a curve that may bend towards the next one, as VTK has them. `midpoint` is where, as a
/// fraction of the way, half of the change is done; `sharpness` leads from a straight line (0) to a step (1).
struct BentPoint {
  ControlPoint point;
  double midpoint = 0.5;
  double sharpness = 0.0;
};

/// What lies between the points of a curve.
struct SegmentRule {
  ColorSpace space = ColorSpace::rgb;
  bool isLogarithmic = false; ///< fractions of the way are taken of log10 of the value
};

/// By how much straight segments may differ from curved ones, in opacity and colour.
inline constexpr double segmentTolerance = 0.01;

/// As checkedCurve of straight curves (LookCurves.h).
std::vector<BentPoint> checkedCurve(std::vector<BentPoint> points, const std::string& name,
                                    std::vector<Message>& changes);

/// The curve with straight segments, within segmentTolerance of the curved ones with as few points as that
/// needs; straight ones and steps stay exact. `points` ascend in value. A sentence is added where it is an
/// approximation, and where VTK itself would draw an opacity otherwise. Throws Error (input), naming `name`,
/// where a logarithmic curve has values that are not positive, or more than mostLookPoints would be needed.
std::vector<ControlPoint> straightened(const std::vector<BentPoint>& points, const SegmentRule& rule,
                                       const std::string& name, std::vector<Message>& changes);

} // namespace limn
