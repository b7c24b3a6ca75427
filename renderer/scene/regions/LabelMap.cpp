// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/regions/LabelMap.h"

#include "scene/basics/Error.h"

namespace limn {
namespace {

void enclose(VoxelBox& box, const glm::ivec3& lower, const glm::ivec3& upper) {
  const bool isFirst = box.lower == box.upper;
  box = isFirst ? VoxelBox{lower, upper} : VoxelBox{glm::min(box.lower, lower), glm::max(box.upper, upper)};
}

/// The smallest box around each label, run by run of each row.
template <class Place>
std::vector<VoxelBox> boxesAround(const StoredVoxels<Place>& places, const glm::ivec3& dims,
                                  std::size_t labels) {
  std::vector<VoxelBox> boxes(labels);
  const Place* row = places.data();
  for (int k = 0; k < dims.z; ++k)
    for (int j = 0; j < dims.y; ++j, row += dims.x)
      for (int first = 0, end = 0; first < dims.x; first = end) {
        const Place place = row[first];
        if (place >= labels)
          throw Error(Error::Kind::input, Message::tr("A voxel's label is missing in the list of labels."));
        while (end < dims.x && row[end] == place)
          ++end;
        enclose(boxes[place], {first, j, k}, {end, j + 1, k + 1});
      }
  return boxes;
}

} // namespace

LabelMap::LabelMap(const glm::ivec3& dims, Places places, std::vector<Label> labels)
    : m_dims(dims), m_places(std::move(places)), m_labels(std::move(labels)) {
  if (m_labels.empty() || m_labels.size() > 65536)
    throw Error(Error::Kind::input,
                Message::tr("A label map has 1 to 65536 labels; this one has %1.").arg(m_labels.size()));
  const auto voxels = static_cast<std::size_t>(dims.x) * dims.y * dims.z;
  std::visit(
      [&](const auto& all) {
        if (all.size() != voxels)
          throw Error(Error::Kind::input,
                      Message::tr("A label map has one label for each voxel; this one has %1 for %2.")
                          .arg(all.size(), voxels));
        m_boxes = boxesAround(all, dims, m_labels.size());
      },
      m_places);
}

std::size_t LabelMap::placeAt(std::size_t voxel) const {
  return std::visit([voxel](const auto& all) -> std::size_t { return all[voxel]; }, m_places);
}

} // namespace limn
