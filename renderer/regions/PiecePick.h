// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "regions/BitGrid.h"
#include "scene/Scene.h"

#include <optional>

namespace limn {

/// The range of values that a curve shows without a gap around `value`: opacities of at least 0.02. Around a
/// value that it does not show, the nearest such range; nothing where it shows none. Ends beyond the
/// outermost point are those of the volume's values.
std::optional<glm::dvec2> shownRangeAround(const TransferFunction& function, const ValueRange& values,
                                           double value);

/// The piece that is meant where a place is pointed at: its seed is the nearest voxel within three that is
/// kept and whose value the curve shows, its range what the curve shows around that value. Nothing where
/// there is none.
std::optional<ConnectedPiece> pieceAt(const Scene& scene, const glm::dvec3& worldMm);

/// The same piece with a range that is narrower by so many notches, each a fiftieth of the volume's range, or
/// wider (negative): the end that does not lie at an end of the volume's values moves, or both do. The value
/// at the seed stays within it.
ConnectedPiece narrowed(const ConnectedPiece& piece, const Volume& volume, double notches);

/// How large a set of voxels is, and which values they have.
struct SetFigures {
  double millilitres = 0.0;
  double mean = 0.0;
  ValueRange values;
};

/// Of the valid voxels of a set; all 0 where there are none. Throws Cancelled.
SetFigures figuresOf(const BitGrid& set, const Volume& volume, const Effort& effort = {});

} // namespace limn
