// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Effort.h"
#include "scene/framing/KeptVoxels.h"
#include "scene/function/TransferFunction.h"
#include "scene/volume/Volume.h"

#include <vector>

namespace limn {

/// What lies on the two sides of a place on a boundary, scalar units.
struct LowAndHigh {
  double low = 0.0;
  double high = 0.0;
  bool operator==(const LowAndHigh&) const = default;
};

/// Where many places agree.
struct LowHighPeak {
  LowAndHigh at;
  double share = 0.0; ///< of all places, 0..1
};

/// The peaks of a histogram of places, the largest first. Every place belongs to the one that is reached from
/// it by going up. The order of the places does not matter.
std::vector<LowHighPeak> peaksOf(std::vector<LowAndHigh> places);

/// Where two materials touch in a volume: the values on both sides, scalar units.
struct Boundary {
  double low = 0.0;
  double high = 0.0;
  double share = 0.0; ///< of the boundary that was looked at, 0..1
  bool operator==(const Boundary&) const = default;

  /// Half-way: what a surface between the two is drawn at.
  double value() const { return (low + high) / 2.0; }
};

/// The boundaries of a volume, the largest first; those of less than a hundredth of all are left out. None
/// where nothing changes.
///
/// Of voxels whose gradient is as strong as any near them along itself the field is followed along the
/// gradient, up and down, to where it stops changing. The two values of all of them fill a histogram, whose
/// peaks are boundaries (P. Šereda et al., IEEE TVCG 12 (2006) 208, "LH histograms"); in the histogram of
/// value and gradient (G. Kindlmann, J. Durkin, IEEE VolVis 1998) each would be an arch from `low` to `high`
/// with its top at `value()`, which crosses others. Costs two passes over the voxels; throws Cancelled.
std::vector<Boundary> boundariesOf(const Volume& volume, const Effort& effort = {});

/// The same of the voxels that are kept alone. What a change is, and how far it reaches, the whole volume
/// tells.
std::vector<Boundary> boundariesOf(const Volume& volume, const KeptVoxels& kept, const Effort& effort = {});

/// A band of the transfer function that makes one boundary visible.
struct Suggestion {
  Boundary boundary;
  ControlPoint from; ///< where the band begins; its opacity is 0
  ControlPoint top;  ///< at the boundary's value
  ControlPoint to;   ///< where it ends, of the top's opacity where nothing lies above it, else 0
  bool operator==(const Suggestion&) const = default;
};

/// A band for each boundary of a volume that counts, the most prominent (large and of high contrast) first.
/// They are told apart by colour; the higher the value, the more opaque, so that what lies inside is seen
/// through what is around it. `range` is the volume's, in the boundaries' unit.
std::vector<Suggestion> suggestionsFor(const std::vector<Boundary>& boundaries, const ValueRange& range);

/// The function, or the band where that is more opaque: nothing that shows becomes more transparent.
TransferFunction withBand(const TransferFunction& function, const Suggestion& suggestion);

} // namespace limn
