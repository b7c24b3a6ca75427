// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "scene/view/Camera.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace limn {

/// A closed line drawn on a picture, and which voxels it takes away (DEFINITION section 10).
struct Scissors {
  Camera camera;       ///< under which it was drawn; voxels behind it stay
  double aspect = 1.0; ///< of the picture that it was drawn on, width over height, > 0
  std::vector<glm::dvec2>
      polygon;               ///< at least 3 corners, in halves of the picture's height from its middle, y up
  bool removesInside = true; ///< or what projects outside
  std::optional<glm::dvec2> depthMm; ///< nearest and farthest place along the rays that it reaches
  bool operator==(const Scissors&) const = default;
};

/// What hangs together with a place in a range of scalars, and what becomes of it (DEFINITION section 10).
struct ConnectedPiece {
  enum class Fate { hidden, alone, ownLook }; ///< goes, stays while all else goes, or shows by its own look
  glm::dvec3 seedMm{0.0};                     ///< world
  glm::dvec2 range{0.0, 0.0};                 ///< of scalars, both ends included
  int growVoxels = 1;                         ///< ≥ 0, into what is outside the range
  Fate fate = Fate::hidden;
  TransferFunction look{};         ///< of fate ownLook
  std::optional<double> reachMm{}; ///< > 0: what lies farther from the seed is no part of it; absent: any is
  bool operator==(const ConnectedPiece&) const = default;
};

/// One thing that was cut out of a volume by hand, or told apart in it: kept as what was done, not as the
/// voxels that it took.
struct Cut {
  std::variant<Scissors, ConnectedPiece> how;
  bool isOn = true;
  std::string name = {}; ///< given by a person, UTF-8; empty: none
  bool operator==(const Cut&) const = default;
};

/// Whether it is on and takes voxels away.
bool takesAway(const Cut& cut);

/// The piece that a cut gives a look of its own; null where it is off or does something else.
const ConnectedPiece* pieceWithLook(const Cut& cut);

} // namespace limn
