// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planes/PlaneGrid.h"
#include "scene/regions/Region.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace limn {

/// Which label lies under each pixel of a slice, x fastest: its place in the list, or `nowhere` outside the
/// volume.
struct PlanePlaces {
  static constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();
  glm::ivec2 size{0};
  std::vector<std::uint32_t> places;
};

/// The labels of the voxels nearest to the pixels of a plane. `grid` is the map's own.
PlanePlaces placesOn(const LabelMap& map, const Grid& grid, const PlaneGrid& plane);

/// Paints labels over the pixels of a slice (0xAARRGGBB, premultiplied): a line of `thickness` pixels inside
/// each where another one begins, and `cover` 0..1 of its colour within. `colors` has an opaque colour for
/// each label, 0 for one that is not painted; pixels outside the volume stay as they are.
void paintLabels(std::vector<std::uint32_t>& pixels, const PlanePlaces& labels,
                 const std::vector<std::uint32_t>& colors, double cover, int thickness);

} // namespace limn
