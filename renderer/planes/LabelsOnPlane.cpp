// SPDX-License-Identifier: GPL-3.0-or-later
#include "planes/LabelsOnPlane.h"

#include "scene/basics/Effort.h"
#include "scene/volume/NearestVoxel.h"

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// A share of one colour over another, channel by channel.
std::uint32_t blended(std::uint32_t below, std::uint32_t above, double cover) {
  std::uint32_t mixed = below & 0xff000000U;
  for (int shift = 0; shift < 24; shift += 8) {
    const double from = below >> shift & 0xffU, to = above >> shift & 0xffU;
    mixed |= static_cast<std::uint32_t>(std::lround(from + cover * (to - from))) << shift;
  }
  return mixed;
}

// Whether another label, or the end of the volume, lies at most so many pixels beside, above or below.
bool isAtItsEdge(const PlanePlaces& labels, int x, int y, int thickness) {
  const std::uint32_t own = labels.places[static_cast<std::size_t>(y) * labels.size.x + x];
  const auto differs = [&](int i, int j) {
    const bool isSeen = i >= 0 && j >= 0 && i < labels.size.x && j < labels.size.y;
    return isSeen && labels.places[static_cast<std::size_t>(j) * labels.size.x + i] != own;
  };
  for (int away = 1; away <= thickness; ++away)
    if (differs(x - away, y) || differs(x + away, y) || differs(x, y - away) || differs(x, y + away))
      return true;
  return false;
}

} // namespace

PlanePlaces placesOn(const LabelMap& map, const Grid& grid, const PlaneGrid& plane) {
  PlanePlaces labels{plane.size,
                     std::vector<std::uint32_t>(static_cast<std::size_t>(plane.size.x) * plane.size.y,
                                                PlanePlaces::nowhere)};
  // World to index is affine: a pixel further is the same step everywhere.
  const glm::dvec3 first = worldToIndex(grid, pixelToWorld(plane, {0.0, 0.0}));
  const glm::dvec3 right = worldToIndex(grid, pixelToWorld(plane, {1.0, 0.0})) - first;
  const glm::dvec3 down = worldToIndex(grid, pixelToWorld(plane, {0.0, 1.0})) - first;
  forEachPiece(plane.size.y, {}, [&](int y) {
    for (int x = 0; x < plane.size.x; ++x) {
      const glm::dvec3 index = first + static_cast<double>(x) * right + static_cast<double>(y) * down;
      if (const std::optional<glm::ivec3> voxel = nearestVoxel(index, map.dims()))
        labels.places[static_cast<std::size_t>(y) * plane.size.x + x] =
            static_cast<std::uint32_t>(map.placeAt(voxelOffset(map.dims(), voxel->x, voxel->y, voxel->z)));
    }
  });
  return labels;
}

void paintLabels(std::vector<std::uint32_t>& pixels, const PlanePlaces& labels,
                 const std::vector<std::uint32_t>& colors, double cover, int thickness) {
  forEachPiece(labels.size.y, {}, [&](int y) {
    for (int x = 0; x < labels.size.x; ++x) {
      const std::size_t at = static_cast<std::size_t>(y) * labels.size.x + x;
      const std::uint32_t place = labels.places[at];
      const std::uint32_t color = place < colors.size() ? colors[place] : 0;
      if (color != 0 && pixels[at] != 0)
        pixels[at] = isAtItsEdge(labels, x, y, thickness) ? color : blended(pixels[at], color, cover);
    }
  });
}

} // namespace limn
