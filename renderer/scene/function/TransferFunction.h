// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

namespace limn {

/// One control point: a scalar value (HU for CT), its display colour (sRGB-encoded, 0..1) and its opacity
/// over the unit distance (0..1).
struct ControlPoint {
  double value = 0.0;
  glm::dvec3 color{1.0};
  double opacity = 0.0;
  bool operator==(const ControlPoint&) const = default;
};

/// Maps a scalar to colour and opacity: linear between control points, constant outside, a step where two
/// points share a value (DEFINITION section 3; lecture, "transfer function"). A plain value: edits return
/// copies.
struct TransferFunction {
  double unitDistanceMm = 1.0;      ///< the length over which a point's opacity holds, > 0
  std::vector<ControlPoint> points; ///< ascending in value; no points: everything is transparent

  bool operator==(const TransferFunction&) const = default;
};

/// Colour and opacity of one scalar.
struct Classified {
  glm::dvec3 color{0.0};
  double opacity = 0.0;
};

/// Classifies a scalar exactly. At the value of a step the last of its points holds.
Classified classify(const TransferFunction& function, double value);

/// The largest opacity of values from `low` to `high`, ends included; 0 without points.
double largestOpacityWithin(const TransferFunction& function, double low, double high);

/// The extinction per millimetre of an opacity over the unit distance: `-log1p(-a)/u`, with `a` limited to
/// [0, 1 - 2⁻²⁴].
double extinctionPerMm(double opacity, double unitDistanceMm);

/// Sorts points by value, keeping the order of equal values, and limits colours and opacities to 0..1.
/// Throws Error (input) where a number is not finite or the unit distance is not positive.
TransferFunction normalised(TransferFunction function);

/// Adds a point of the function's own colour at its place; opacity is limited to 0..1. `index`, if given,
/// receives where it went.
TransferFunction withPointAdded(const TransferFunction& function, double value, double opacity,
                                std::size_t* index = nullptr);

/// Moves a point; it stops at the values of its neighbours, and its opacity at 0 and 1.
TransferFunction withPointMoved(const TransferFunction& function, std::size_t index, double value,
                                double opacity);

/// Removes points by index; the others keep their order. Indices out of range are ignored.
TransferFunction withoutPoints(const TransferFunction& function, const std::vector<std::size_t>& indices);

/// Gives a point another colour, 0..1.
TransferFunction withPointColored(const TransferFunction& function, std::size_t index,
                                  const glm::dvec3& color);

/// Moves every point along the value axis by `offset`.
TransferFunction shifted(const TransferFunction& function, double offset);

/// Stretches the function about `centre` by `factor` > 0 along the value axis.
TransferFunction stretched(const TransferFunction& function, double centre, double factor);

/// Multiplies every opacity; zero stays zero, and the result is limited to 1.
TransferFunction withOpacityScaled(const TransferFunction& function, double factor);

} // namespace limn
