// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/curves/PointLook.h"

#include <array>

namespace limn {

/// A colour map as MRIcroGL and niivue keep it: nodes at 0..255 of a range of values, colours in bytes.
struct ByteNodes {
  struct Node {
    double intensity = 0.0;       ///< 0..255
    std::array<double, 4> rgba{}; ///< 0..255 each
  };
  double low = 0.0;  ///< the value of intensity 0
  double high = 0.0; ///< of 255; both the same: of the volume's own range
  std::vector<Node> nodes;
};

/// The points of a map: value = low + intensity/255 (high - low). Throws Error (input), naming `file`, where
/// the range is upside down or an intensity lies outside 0..255.
PointLook pointLook(const ByteNodes& map, const std::string& file);

/// The map nearest to a function, which has points: over the range of its points, everything rounded to whole
/// numbers. Says in `changes` what that changed.
ByteNodes byteNodes(const TransferFunction& function, std::vector<Message>& changes);

} // namespace limn
