// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/regions/Region.h"

#include <map>
#include <string>
#include <vector>

namespace limn {

/// What a scene file says of the kept region: a Region is made of it once the volume is read.
struct KeptPart {
  Region::Kind kind = Region::Kind::all;
  std::string
      labels; ///< of kind labels: the path of the label map, as written in the file; the first of masks
  std::map<int, double> weights;           ///< 0..1, by the labels' values; what is not named weighs 1
  std::vector<Cut> cuts{};                 ///< in order
  std::map<int, TransferFunction> looks{}; ///< of their own, by the labels' values
  bool hidesTable = false;                 ///< of kind labels: what is not the body is hidden, too
  std::vector<std::string> moreLabels{};   ///< of masks in several files: the paths of the others, in order
  bool operator==(const KeptPart&) const = default;
};

/// What is to be written of a region.
KeptPart keptPartOf(const Region& region);

/// The region of a label map with the looks that labels have of their own, by their values. Throws Error
/// (input) for a look of a label that is not among them, and where more differ than can be drawn; `labelMap`
/// is how the sentence calls the file.
Region withLooksOf(const Region& region, const std::map<int, TransferFunction>& looks,
                   const std::string& labelMap);

/// The weight of each of the labels, in their order. Throws Error (input) for a weight of a label that is not
/// among them; `labelMap` is how the sentence calls the file.
std::vector<double> weightsOf(const std::vector<Label>& labels, const std::map<int, double>& weights,
                              const std::string& labelMap);

} // namespace limn
