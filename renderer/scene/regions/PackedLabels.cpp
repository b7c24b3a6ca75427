// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/regions/PackedLabels.h"

#include "scene/basics/Effort.h"
#include "scene/basics/Error.h"
#include "scene/regions/LabelRuns.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <span>

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
void unpack(std::span<const std::uint8_t> bytes, std::size_t voxels, Place* slice) {
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
LabelMap::Places unpacked(std::span<const std::uint8_t> bytes, const std::vector<std::size_t>& ends,
                          std::size_t voxelsOfSlice, const std::shared_ptr<Room>& room) {
  RoomVector<Place> places(ends.size() * voxelsOfSlice, room);
  forEachPiece(static_cast<int>(ends.size()), {}, [&](int z) {
    const auto slice = static_cast<std::size_t>(z);
    const std::size_t begin = slice == 0 ? 0 : ends[slice - 1];
    unpack(bytes.subspan(begin, ends[slice] - begin), voxelsOfSlice, places.data() + slice * voxelsOfSlice);
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
  m_runs = std::async(std::launch::async, [held = map]() mutable {
             std::shared_ptr<Runs> runs = runsOf(*held);
             held.reset();
             return runs;
           }).share();
}

std::shared_ptr<PackedLabels::Runs> PackedLabels::runsOf(const LabelMap& map) {
  const std::vector<std::vector<std::uint8_t>> slices = slicesOf(map);
  auto runs = std::make_shared<Runs>();
  std::size_t end = 0;
  for (const std::vector<std::uint8_t>& slice : slices)
    runs->ends.push_back(end += slice.size());
  runs->bytes.reserve(end);
  for (const std::vector<std::uint8_t>& slice : slices)
    runs->bytes.insert(runs->bytes.end(), slice.begin(), slice.end());
  return runs;
}

std::shared_ptr<const LabelMap> PackedLabels::map() const {
  if (std::shared_ptr<const LabelMap> known = m_map.lock())
    return known;
  const std::size_t voxels = static_cast<std::size_t>(m_dims.x) * static_cast<std::size_t>(m_dims.y);
  const Runs& runs = *m_runs.get();
  auto map = std::make_shared<const LabelMap>(
      m_dims,
      m_isOfBytes ? unpacked<std::uint8_t>(runs.bytes, runs.ends, voxels, m_room)
                  : unpacked<std::uint16_t>(runs.bytes, runs.ends, voxels, m_room),
      m_labels);
  m_map = map;
  return map;
}

std::size_t PackedLabels::bytes() const {
  return m_runs.get()->bytes.size();
}

bool PackedLabels::isFound() const {
  return m_runs.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

std::size_t PackedLabels::bytesInMemory() const {
  return isFound() && !m_runs.get()->isAside ? bytes() : 0;
}

void PackedLabels::putAside(const std::shared_ptr<Room>& aside) const {
  if (bytesInMemory() < Room::smallest) // none are found, or they are not worth a file
    return;
  Runs& runs = *m_runs.get();
  try {
    RoomVector<std::uint8_t> there(runs.bytes.size(), aside);
    std::ranges::copy(runs.bytes, there.begin());
    runs.bytes = std::move(there);
    runs.isAside = true;
  } catch (const Error&) {
    // A history that takes more memory is better than none.
  }
}

} // namespace limn
