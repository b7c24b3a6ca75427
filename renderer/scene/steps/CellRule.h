// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace limn {

// Cell by cell: between voxel centres the scalars along a ray are a cubic, and a transfer function is linear
// between its control points, so a ray divides into pieces on which everything is smooth. Each is integrated
// by panels, quadratics through three nodes, which are halved until the light of the piece stands still. The
// rule is the same for the reference in double and for the CPU engine in float.

/// The most nodes of a piece: four panels. One whose light still moves is cut into equal parts, each a piece
/// of its own, so many times at most.
inline constexpr int cellNodes = 9;
inline constexpr int cellParts = 8;
inline constexpr int cellCuts = 3;

/// The largest change of the light that a piece adds to a channel of the pixel (0..1), from one estimate to
/// the next of twice the nodes, with which the latter is kept. What the new nodes add that the panels before
/// did not foresee counts as a change, too, node by node: sums of both kinds may agree by chance, as where
/// light sets in within a piece. The constant has fineness 4 err by about a level on heads, as
/// usualFineness() says, and the error halves with each fineness (limn_tolerance_spent).
inline double largestPieceChange(double fineness) {
  return 0.06 * std::exp2(-fineness);
}

/// A piece that adds no more light than so many of those changes is estimated once.
inline constexpr double faintPieces = 4.0;

/// Equal steps may come first, of so many smallest spacings: an error of theirs that falls with the square of
/// the step halves with each fineness, too. With finer ones cells take less time.
inline double sampledStep(double fineness) {
  return 0.25 * std::exp2(-0.5 * std::max(fineness - 4.0, -1.0));
}
inline constexpr double mostSampledFineness = 6.5;

/// What a ray of equal steps may seem to be off, as a root of summed squares of second differences (0..1 of a
/// channel): beyond it the worst of its parts are integrated cell by cell.
inline double largestRayError(double fineness) {
  return 0.22 * std::exp2(-fineness);
}

/// Scalars are looked at, and surfaces met, where the kept region leaves at least so much.
inline constexpr double keptWeight = 0.5;

/// A point of Gauss's rule of three on 0..1, and the weights of three extinctions (at 0, ½ and 1, between
/// which they are a quadratic) in the optical depth up to it.
struct GaussPoint {
  float place, weight;
  float depth[3];
};

constexpr GaussPoint gaussPoint(double s, double weight) {
  const double square = s * s, cube = square * s;
  return {static_cast<float>(s),
          static_cast<float>(weight),
          {static_cast<float>(s - 1.5 * square + 2.0 / 3.0 * cube),
           static_cast<float>(2.0 * square - 4.0 / 3.0 * cube),
           static_cast<float>(-0.5 * square + 2.0 / 3.0 * cube)}};
}

inline constexpr GaussPoint gaussPoints[3] = {gaussPoint(0.1127016653792583, 5.0 / 18.0),
                                              gaussPoint(0.5, 4.0 / 9.0),
                                              gaussPoint(0.8872983346207417, 5.0 / 18.0)};

} // namespace limn
