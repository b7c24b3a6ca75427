// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/steps/RayFrame.h"

#include <vector>

namespace limn {

/// The box of a volume that a crop leaves, divided by planes across its axes into bricks of nearly equal
/// size. Bricks are half open boxes in centred index coordinates; faces on the end of the whole box lie
/// infinitely far, so that every sample of a ray lies in exactly one brick.
class Bricks {
public:
  /// `count` ≥ 1 bricks; where there are more of them than slices, bricks are thinner than a voxel.
  Bricks(const Grid& grid, const CropBox& crop, int count);

  int count() const { return static_cast<int>(m_boxes.size()); }
  const IndexBox& box(int brick) const { return m_boxes[static_cast<std::size_t>(brick)]; }

  /// All bricks, so ordered that no ray of the picture enters one before another that stands in front of it.
  /// Such an order exists for every camera, one within the box or on a face as well: on each plane the side
  /// of the eye comes first.
  std::vector<int> frontToBack(const RayFrame& frame) const;

private:
  // Bricks first … first + count - 1; those below the plane are the first `below` of them.
  struct Split {
    int first, below, count;
    int axis;
    double plane;
  };

  void divide(const IndexBox& inner, const IndexBox& outer, int first, int count);

  std::vector<IndexBox> m_boxes;
  std::vector<Split> m_splits; // each before those of its parts
};

} // namespace limn
