// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/RegionStore.h"

#include "scene/steps/BlockRanges.h"

#include <algorithm>

namespace limn::cpu {
namespace {

// Whether the place of a label in its list is its weight: 0, or 0 and 1.
bool placesAreWeights(const Region& region) {
  for (std::size_t place = 0; place < region.weights.size(); ++place)
    if (region.weights[place] != static_cast<double>(place))
      return false;
  return std::holds_alternative<StoredVoxels<std::uint8_t>>(region.labels->places());
}

template <class Weights>
VoxelSource sourceOf(VoxelSource::Kind kind, const Weights& weights, const glm::ivec3& dims, float scale) {
  constexpr std::size_t each = sizeof(typename Weights::value_type);
  VoxelSource source;
  source.kind = kind;
  source.begin = reinterpret_cast<const unsigned char*>(weights.data());
  source.bytes = static_cast<std::int64_t>(weights.size() * each);
  source.scale = scale;
  source.dims = dims;
  const std::int64_t row = std::int64_t{each} * dims.x;
  source.strideY = dims.y > 1 ? row : 0;
  source.strideZ = dims.z > 1 ? row * dims.y : 0;
  return source;
}

} // namespace

void RegionStore::update(const Region& region, const BlockBox& box, const std::shared_ptr<Room>& room,
                         const Effort& effort) {
  if (m_region == region && m_box == box)
    return;
  m_region = {}; // should it be cancelled
  m_shares = RoomVector<std::uint16_t>(room);
  m_blocks = BlockWeights(room);
  if (isRestricting(region)) {
    m_blocks = blockWeights(region, {box.upper - box.lower, glm::ivec3(blockSize), box.lower}, effort, room);
    const LabelMap& labels = *region.labels;
    if (placesAreWeights(region)) {
      m_source = sourceOf(VoxelSource::Kind::byte, std::get<StoredVoxels<std::uint8_t>>(labels.places()),
                          labels.dims(), 1.0f);
    } else {
      m_shares.resize(static_cast<std::size_t>(labels.dims().x) * labels.dims().y * labels.dims().z);
      const std::size_t pieces = (m_shares.size() + voxelsPerPiece - 1) / voxelsPerPiece;
      forEachPiece(static_cast<int>(pieces), effort, [&](int piece) {
        const std::size_t from = static_cast<std::size_t>(piece) * voxelsPerPiece;
        const std::size_t count = std::min<std::size_t>(voxelsPerPiece, m_shares.size() - from);
        sharesOf(region, from, count, &m_shares[from]);
      });
      m_source = sourceOf(VoxelSource::Kind::half, m_shares, labels.dims(), 1.0f / 65535.0f);
    }
  }
  m_region = region;
  m_box = box;
}

} // namespace limn::cpu
