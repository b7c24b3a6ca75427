// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/regions/LabelMap.h"

#include "scene/basics/Error.h"

#include <algorithm>

namespace limn {

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
                          .arg(all.size())
                          .arg(voxels));
        if (!all.empty() && *std::max_element(all.begin(), all.end()) >= m_labels.size())
          throw Error(Error::Kind::input, Message::tr("A voxel's label is missing in the list of labels."));
      },
      m_places);
}

std::size_t LabelMap::placeAt(std::size_t voxel) const {
  return std::visit([voxel](const auto& all) -> std::size_t { return all[voxel]; }, m_places);
}

} // namespace limn
