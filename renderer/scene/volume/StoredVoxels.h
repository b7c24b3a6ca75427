// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/basics/Room.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <variant>
#include <vector>

namespace limn {

/// Voxels of one type, one behind the other: in memory, or in a file that is mapped. Copies share them;
/// nobody changes them but who owns them alone.
template <class T>
class StoredVoxels {
public:
  using value_type = T;

  StoredVoxels() = default;

  /// Takes the values.
  template <class Allocator>
  StoredVoxels(std::vector<T, Allocator> values) {
    auto owner = std::make_shared<std::vector<T, Allocator>>(std::move(values));
    m_voxels = *owner;
    m_writable = owner->data();
    m_owner = std::move(owner);
  }

  /// Voxels that `owner` keeps where they are; they are only read.
  StoredVoxels(std::span<const T> voxels, std::shared_ptr<const void> owner)
      : m_voxels(voxels), m_owner(std::move(owner)) {}

  std::size_t size() const { return m_voxels.size(); }
  const T* data() const { return m_voxels.data(); }
  const T& operator[](std::size_t voxel) const { return m_voxels[voxel]; }
  auto begin() const { return m_voxels.begin(); }
  auto end() const { return m_voxels.end(); }

  /// Where they may be changed: in their place, or in a copy that lies in `room` where others read them or
  /// they cannot be written.
  std::span<T> writable(const std::shared_ptr<Room>& room = {}) {
    if (!m_writable || m_owner.use_count() > 1)
      *this = StoredVoxels(RoomVector<T>(begin(), end(), room));
    return {m_writable, size()};
  }

  friend bool operator==(const StoredVoxels& a, const StoredVoxels& b) {
    return std::ranges::equal(a.m_voxels, b.m_voxels);
  }

private:
  std::span<const T> m_voxels;
  std::shared_ptr<const void> m_owner;
  T* m_writable = nullptr; // the first voxel, where it may be written
};

/// One `Of` for each type in which voxels are stored. 64-bit integers become double on reading.
template <template <class> class Of>
using OfStoredType = std::variant<Of<std::uint8_t>, Of<std::int8_t>, Of<std::uint16_t>, Of<std::int16_t>,
                                  Of<std::uint32_t>, Of<std::int32_t>, Of<float>, Of<double>>;

/// Stored voxels, x fastest, then y, then z.
using VoxelArray = OfStoredType<StoredVoxels>;

/// Voxels while they are read, in a room or in memory.
using VoxelVectors = OfStoredType<RoomVector>;

/// Takes what was read over, without copying it.
inline VoxelArray storedVoxels(VoxelVectors voxels) {
  return std::visit([](auto& values) -> VoxelArray { return std::move(values); }, voxels);
}

} // namespace limn
