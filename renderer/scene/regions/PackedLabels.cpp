// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/regions/PackedLabels.h"

#include "scene/basics/Effort.h"
#include "scene/regions/LabelRuns.h"

#include <algorithm>
#include <cstring>

namespace limn {
namespace {

template <class Value>
void append(std::vector<std::uint8_t>& bytes, const Value& value) {
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof(Value));
  std::memcpy(bytes.data() + at, &value, sizeof(Value));
}

template <class Place>
std::vector<std::uint8_t> packed(const Place* slice, int width, int rows) {
  const std::size_t plain = sizeof(Place) * static_cast<std::size_t>(width) * static_cast<std::size_t>(rows);
  std::vector<std::uint8_t> runs;
  for (int y = 0; y < rows; ++y) {
    const Place* row = slice + static_cast<std::ptrdiff_t>(y) * width;
    for (int first = 0, end = 0; first < width; first = end) {
      end = endOfRun(row, first, std::min(width, first + 0xFFFF));
      append(runs, row[first]);
      append(runs, static_cast<std::uint16_t>(end - first));
    }
    // As many bytes as the voxels tell that they are no runs: fewer could not be told apart from them.
    if (runs.size() >= plain) {
      runs.resize(plain);
      std::memcpy(runs.data(), slice, plain);
      return runs;
    }
  }
  runs.shrink_to_fit();
  return runs;
}

template <class Place>
void unpack(const std::vector<std::uint8_t>& bytes, std::size_t voxels, Place* slice) {
  if (bytes.size() == sizeof(Place) * voxels) {
    std::memcpy(slice, bytes.data(), bytes.size());
    return;
  }
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(Place) + sizeof(std::uint16_t)) {
    Place place{};
    std::uint16_t length = 0;
    std::memcpy(&place, bytes.data() + at, sizeof(place));
    std::memcpy(&length, bytes.data() + at + sizeof(place), sizeof(length));
    slice = std::fill_n(slice, length, place);
  }
}

template <class Place>
LabelMap::Places unpacked(const std::vector<std::vector<std::uint8_t>>& slices, std::size_t voxelsOfSlice,
                          const std::shared_ptr<Room>& room) {
  RoomVector<Place> places(slices.size() * voxelsOfSlice, room);
  forEachPiece(static_cast<int>(slices.size()), {}, [&](int z) {
    const auto slice = static_cast<std::size_t>(z);
    unpack(slices[slice], voxelsOfSlice, places.data() + slice * voxelsOfSlice);
  });
  return StoredVoxels<Place>(std::move(places));
}

std::vector<std::vector<std::uint8_t>> slicesOf(const LabelMap& map) {
  const glm::ivec3& dims = map.dims();
  std::vector<std::vector<std::uint8_t>> slices(static_cast<std::size_t>(dims.z));
  std::visit(
      [&](const auto& places) {
        forEachPiece(dims.z, {}, [&](int z) {
          slices[static_cast<std::size_t>(z)] =
              packed(places.data() + voxelOffset(dims, 0, 0, z), dims.x, dims.y);
        });
      },
      map.places());
  return slices;
}

} // namespace

PackedLabels::PackedLabels(const std::shared_ptr<const LabelMap>& map, std::shared_ptr<Room> room)
    : m_dims(map->dims()), m_labels(map->labels()), m_isOfBytes(map->places().index() == 0),
      m_room(std::move(room)), m_map(map) {
  // What was asked for outlives its answer: the map is let go by hand.
  m_slices = std::async(std::launch::async, [held = map]() mutable {
               Slices slices = slicesOf(*held);
               held.reset();
               return slices;
             }).share();
}

std::shared_ptr<const LabelMap> PackedLabels::map() const {
  if (std::shared_ptr<const LabelMap> known = m_map.lock())
    return known;
  const std::size_t voxels = static_cast<std::size_t>(m_dims.x) * static_cast<std::size_t>(m_dims.y);
  const Slices& slices = m_slices.get();
  auto map = std::make_shared<const LabelMap>(m_dims,
                                              m_isOfBytes ? unpacked<std::uint8_t>(slices, voxels, m_room)
                                                          : unpacked<std::uint16_t>(slices, voxels, m_room),
                                              m_labels);
  m_map = map;
  return map;
}

std::size_t PackedLabels::bytes() const {
  std::size_t bytes = 0;
  for (const std::vector<std::uint8_t>& slice : m_slices.get())
    bytes += slice.size();
  return bytes;
}

} // namespace limn
