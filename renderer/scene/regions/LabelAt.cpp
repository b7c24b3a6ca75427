// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/regions/LabelAt.h"

#include "scene/volume/NearestVoxel.h"

namespace limn {

namespace {

std::optional<std::size_t> placeNearest(const LabelMap& map, const glm::dvec3& index) {
  const std::optional<glm::ivec3> voxel = nearestVoxel(index, map.dims());
  return voxel ? std::optional(map.placeAt(voxelOffset(map.dims(), voxel->x, voxel->y, voxel->z)))
               : std::nullopt;
}

} // namespace

std::optional<std::size_t> voxelLabelAt(const Region& region, const glm::dvec3& index) {
  // What is cut away is one label more, under which the others lie.
  const std::shared_ptr<const LabelMap>& map = region.isCut ? region.uncut : region.labels;
  return region.kind == Region::Kind::labels && map ? placeNearest(*map, index) : std::nullopt;
}

std::string labelNameAt(const Region& region, const glm::dvec3& index) {
  const std::optional<std::size_t> place = voxelLabelAt(region, index);
  if (!place || region.labels->labels()[*place].value == 0)
    return {};
  return region.labels->labels()[*place].name;
}

const TransferFunction* ownLookAt(const Region& region, const glm::dvec3& index) {
  // A piece that was picked lies over the labels, with or without a segmentation.
  const auto lookAt = [&region](const std::optional<std::size_t>& place) {
    const std::size_t look = place ? lookOfLabel(region, *place) : 0;
    return look > 0 ? &region.looks[look - 1] : nullptr;
  };
  const TransferFunction* shown = region.labels ? lookAt(placeNearest(*region.labels, index)) : nullptr;
  return shown ? shown : lookAt(voxelLabelAt(region, index));
}

} // namespace limn
