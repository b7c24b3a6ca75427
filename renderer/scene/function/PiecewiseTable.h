// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "scene/light/Shading.h"
#include "scene/volume/Volume.h"

#include <glm/glm.hpp>

#include <vector>

namespace limn {

/// A knot of a piecewise linear function; several at one x make a step, where the last one holds.
struct Knot {
  double x = 0.0;
  glm::dvec4 value{0.0}; ///< rgb and opacity
};

/// A piecewise linear function as two textures that `shaders/piecewise.glsl` reads without error: no filtered
/// table, so steps stay sharp and spikes survive.
///
/// Segment k reaches from knot k-1 to knot k (half open); segment 0 lies before all knots, the last one
/// after. It takes four texels: colour and opacity at its start, their slopes, (start, end, 0, 0), and the
/// integrals up to its start of colour times extinction (rgb) and of extinction per unit distance (a). A bin
/// holds the start of the segment before its knots, its first two knots (beyond all arguments where it has
/// fewer), and the index of that segment.
struct PiecewiseTable {
  std::vector<glm::vec4> bins;
  std::vector<glm::vec2>
      occupancy;                   ///< the largest opacity in each bin, margins included; visible bins before
  std::vector<glm::vec4> segments; ///< rows of 256 segments
  int segmentCount = 0;
  glm::ivec2 segmentsSize{0}; ///< in texels
  glm::vec3 domain{0.0f};     ///< first x, bins per unit of x, index of the last bin
  int loopSteps = 0;          ///< the most knots beyond two in a bin, which a lookup loops over
};

/// Tabulates knots of ascending x for arguments in `limits`; no knots make the zero function.
PiecewiseTable piecewiseTable(const std::vector<Knot>& knots, const ValueRange& limits);

/// A scalar on the scale of the volume texture: (value - lowest)/(highest - lowest), or value - lowest where
/// the volume is constant. Voxels and control points go through the same arithmetic.
inline double normalisedValue(const ValueRange& range, double value) {
  const double width = range.highest - range.lowest;
  return width > 0.0 ? (value - range.lowest) / width : value - range.lowest;
}

/// The tables of a transfer function and of a gradient-opacity curve (whose x is in `unit` value/mm).
PiecewiseTable tableOf(const TransferFunction& function, const ValueRange& range);
PiecewiseTable tableOf(const GradientOpacity& curve, double unit);

} // namespace limn
