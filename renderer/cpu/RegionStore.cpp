// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/RegionStore.h"

#include "scene/steps/BlockRanges.h"

namespace limn::cpu {
namespace {

// Whether the place of a label in its list is its weight: 0, or 0 and 1.
bool placesAreWeights(const Region& region) {
  for (std::size_t place = 0; place < region.weights.size(); ++place)
    if (region.weights[place] != static_cast<double>(place))
      return false;
  return std::holds_alternative<std::vector<std::uint8_t>>(region.labels->places());
}

template <class T>
VoxelSource sourceOf(VoxelSource::Kind kind, const std::vector<T>& weights, const glm::ivec3& dims,
                     float scale) {
  VoxelSource source;
  source.kind = kind;
  source.begin = reinterpret_cast<const unsigned char*>(weights.data());
  source.bytes = static_cast<std::int64_t>(weights.size() * sizeof(T));
  source.scale = scale;
  source.dims = dims;
  const std::int64_t row = std::int64_t{sizeof(T)} * dims.x;
  source.strideY = dims.y > 1 ? row : 0;
  source.strideZ = dims.z > 1 ? row * dims.y : 0;
  return source;
}

} // namespace

void RegionStore::update(const Region& region, const glm::ivec3& blocks, const Effort& effort) {
  if (m_region == region)
    return;
  m_region = {}; // should it be cancelled
  m_shares.clear();
  m_blocks.clear();
  if (isRestricting(region)) {
    m_blocks = blockWeights(region, {blocks, glm::ivec3(blockSize)}, effort);
    const LabelMap& labels = *region.labels;
    if (placesAreWeights(region)) {
      m_source = sourceOf(VoxelSource::Kind::byte, std::get<std::vector<std::uint8_t>>(labels.places()),
                          labels.dims(), 1.0f);
    } else {
      m_shares.resize(static_cast<std::size_t>(labels.dims().x) * labels.dims().y * labels.dims().z);
      sharesOf(region, 0, m_shares.size(), m_shares.data());
      m_source = sourceOf(VoxelSource::Kind::half, m_shares, labels.dims(), 1.0f / 65535.0f);
    }
  }
  m_region = region;
}

} // namespace limn::cpu
