// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "regions/BitGrid.h"
#include "scene/Scene.h"

#include <optional>

namespace limn {

/// The range of values without a gap around `value` to which a curve gives an opacity of at least `least` >
/// 0. Around a value to which it gives less, the nearest such range; nothing where there is none. Ends beyond
/// the outermost point are those of the volume's values.
std::optional<glm::dvec2> rangeAround(const TransferFunction& function, const ValueRange& values,
                                      double value, double least);

/// The piece that is meant where a place is pointed at: its seed is the most opaque voxel within two that is
/// kept, its range the values around that voxel's with at least half of its opacity, so that bone under a
/// thin veil of skin is bone. Nothing where no voxel there has an opacity of 0.02.
std::optional<ConnectedPiece> pieceAt(const Scene& scene, const glm::dvec3& worldMm);

/// The same piece with a range that is narrower by so many notches, each a fiftieth of the volume's range, or
/// wider (negative): the end that does not lie at an end of the volume's values moves, or both do, then by no
/// more than a tenth of the range each, but at least 0.2 % of the volume's. The value at the seed stays
/// within it.
ConnectedPiece narrowed(const ConnectedPiece& piece, const Volume& volume, double notches);

/// The same piece with an upper end that is lower by so many notches, or higher (negative), each a fifth of
/// what lies between it and the value at the seed, which stays within the range.
ConnectedPiece narrowedAbove(const ConnectedPiece& piece, const Volume& volume, double notches);

/// Whether the range can get no narrower by `narrowed`, because it would leave out the value at the seed.
bool isNarrowest(const ConnectedPiece& piece, const Volume& volume);

/// The same piece with the values that lie around a place, mm of the world: of the voxels of its range within
/// 2 mm and a voxel of which `keep`, a region of the volume's grid, leaves something the mean ± 2.5 standard
/// deviations (99 % of a normal distribution), at least ± 0.5 % of the volume's range. Where its seed is not
/// kept or has none of these values, it is the voxel among them that is nearest to the mean. As it was where
/// none of its range lies there.
ConnectedPiece withValuesAround(const ConnectedPiece& piece, const Volume& volume, const Region& keep,
                                const glm::dvec3& worldMm);

/// How large a set of voxels is, and which values they have.
struct SetFigures {
  double millilitres = 0.0;
  double mean = 0.0;
  ValueRange values;
};

/// Of the valid voxels of a set whose values lie in a range, both ends included; all 0 where there are none.
/// Throws Cancelled.
SetFigures figuresOf(const BitGrid& set, const Volume& volume, const glm::dvec2& range,
                     const Effort& effort = {});

} // namespace limn
