// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace limn {

/// What the voxels of a label say: its volume, and their values. Without valid ones, values are 0.
struct LabelFigures {
  double millilitres = 0.0; ///< of all its voxels
  std::size_t voxels = 0;   ///< valid ones
  double mean = 0.0;        ///< scalar units
  double deviation = 0.0;   ///< the root of the mean squared distance from the mean
  double lowest = 0.0;
  double highest = 0.0;
  bool operator==(const LabelFigures&) const = default;
};

} // namespace limn
