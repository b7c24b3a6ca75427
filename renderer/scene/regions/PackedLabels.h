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

  /// Of the runs as far as they lie in memory: 0 while they are being found, and once they are put aside.
  std::size_t bytesInMemory() const;

  /// Puts runs that are found into `aside`, on the disk, whence `map` reads them. Where that has no place for
  /// them they stay in memory. For the thread that asks for the map.
  void putAside(const std::shared_ptr<Room>& aside) const;

private:
  glm::ivec3 m_dims;
  std::vector<Label> m_labels;
  // Of slice after slice, or voxels where these are fewer bytes.
  struct Runs {
    RoomVector<std::uint8_t> bytes;
    std::vector<std::size_t> ends; ///< of slices, in `bytes`
    bool isAside = false;
  };
  static std::shared_ptr<Runs> runsOf(const LabelMap& map);
  bool isFound() const;

  std::shared_future<std::shared_ptr<Runs>> m_runs;
  bool m_isOfBytes; ///< a voxel, else of two
  std::shared_ptr<Room> m_room;
  mutable std::weak_ptr<const LabelMap> m_map;
};

} // namespace limn
