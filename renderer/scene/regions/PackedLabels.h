// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/regions/Region.h"

#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <vector>

namespace limn {

/// A label map as the runs of equal labels of its rows: what steps of a history hold, of which many differ by
/// a cut and all but one are not looked at. No larger than the map but by a few bytes a slice. They are found
/// beside whoever asks for them, on a thread that holds the map until it is done.
class PackedLabels {
public:
  /// Of a map whose voxels lay in `room`, where they are put again.
  explicit PackedLabels(const std::shared_ptr<const LabelMap>& map, std::shared_ptr<Room> room = {});

  /// The map: the very one while anybody has it, else an equal one.
  std::shared_ptr<const LabelMap> map() const;

  /// Whether it is of this very map.
  bool isOf(const std::shared_ptr<const LabelMap>& map) const { return m_map.lock() == map; }

  /// Of the runs, once they are found.
  std::size_t bytes() const;

private:
  glm::ivec3 m_dims;
  std::vector<Label> m_labels;
  using Slices = std::vector<std::vector<std::uint8_t>>;
  std::shared_future<Slices> m_slices; ///< runs, or voxels where these are fewer bytes
  bool m_isOfBytes;                    ///< a voxel, else of two
  std::shared_ptr<Room> m_room;
  mutable std::weak_ptr<const LabelMap> m_map;
};

} // namespace limn
