// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/RegionStore.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace limn::cpu {
namespace {

// A line on which the weights of labels lie by their places in the list, as any two do: a body's, a cut's.
struct WeightLine {
  double scale = 0.0;
  double shift = 0.0;
};

// Of labels that are bytes; none where they are not, or their weights lie on no line.
std::optional<WeightLine> weightLine(const Region& region) {
  if (!std::holds_alternative<StoredVoxels<std::uint8_t>>(region.labels->places()))
    return std::nullopt;
  const std::vector<double>& weights = region.weights;
  const WeightLine line{weights.size() > 1 ? weights[1] - weights[0] : 0.0, weights[0]};
  for (std::size_t place = 0; place < weights.size(); ++place)
    if (weights[place] != line.shift + line.scale * static_cast<double>(place))
      return std::nullopt;
  return line;
}

// Whether every label is kept wholly or not at all: then a byte says it as well as a share of 16 bits.
bool areWhole(const Region& region) {
  return std::all_of(region.weights.begin(), region.weights.end(),
                     [](double weight) { return weight == 0.0 || weight == 1.0; });
}

void bytesOf(const Region& region, std::size_t first, std::size_t count, std::uint8_t* out) {
  std::vector<std::uint8_t> kept;
  for (const double weight : region.weights)
    kept.push_back(weight > 0.0 ? 1 : 0);
  std::visit(
      [&](const auto& places) {
        for (std::size_t n = 0; n < count; ++n)
          out[n] = kept[places[first + n]];
      },
      region.labels->places());
}

// Fills the weights of all voxels, piece by piece.
template <class Weight, class Fill>
void fillWeights(RoomVector<Weight>& weights, const glm::ivec3& dims, const Effort& effort,
                 const Fill& fill) {
  weights.resize(static_cast<std::size_t>(dims.x) * dims.y * dims.z);
  const std::size_t pieces = (weights.size() + voxelsPerPiece - 1) / voxelsPerPiece;
  forEachPiece(static_cast<int>(pieces), effort, [&](int piece) {
    const std::size_t from = static_cast<std::size_t>(piece) * voxelsPerPiece;
    fill(from, std::min<std::size_t>(voxelsPerPiece, weights.size() - from), &weights[from]);
  });
}

// Whether what is stored for a weight of 1 comes to that to the bit, whether products are rounded or not.
bool readsAsOne(const VoxelSource& source, float stored) {
  const float rounded = source.scale * stored;
  return rounded + source.shift == 1.0f && std::fma(source.scale, stored, source.shift) == 1.0f;
}

} // namespace

void RegionStore::update(const Region& region, const BlockBox& box, const std::shared_ptr<Room>& room,
                         const Effort& effort) {
  if (m_region == region && m_box == box)
    return;
  m_region = {}; // should it be cancelled
  m_shares = RoomVector<std::uint16_t>(room);
  m_bytes = RoomVector<std::uint8_t>(room);
  m_blocks = BlockWeights(room);
  m_whole = BlockDistances(room);
  if (isRestricting(region)) {
    m_blocks = blockWeights(region, {box.upper - box.lower, glm::ivec3(blockSize), box.lower}, effort, room);
    const LabelMap& labels = *region.labels;
    bool isExact = true; // what is kept wholly
    if (const std::optional<WeightLine> line = weightLine(region)) {
      m_source = sourceOf(std::get<StoredVoxels<std::uint8_t>>(labels.places()).data(),
                          VoxelSource::Kind::byte, labels.dims(), static_cast<float>(line->scale));
      m_source.shift = static_cast<float>(line->shift);
      for (std::size_t place = 0; place < region.weights.size(); ++place)
        isExact =
            isExact && (region.weights[place] != 1.0 || readsAsOne(m_source, static_cast<float>(place)));
    } else if (areWhole(region)) {
      fillWeights(m_bytes, labels.dims(), effort, [&region](std::size_t from, std::size_t count, auto* out) {
        bytesOf(region, from, count, out);
      });
      m_source = sourceOf(m_bytes.data(), VoxelSource::Kind::byte, labels.dims());
    } else {
      fillWeights(m_shares, labels.dims(), effort, [&region](std::size_t from, std::size_t count, auto* out) {
        sharesOf(region, from, count, out);
      });
      m_source = sourceOf(m_shares.data(), VoxelSource::Kind::half, labels.dims(), 1.0f / 65535.0f);
      isExact = readsAsOne(m_source, 65535.0f);
    }
    if (isExact)
      findWhole(box.upper - box.lower, effort);
  }
  m_region = region;
  m_box = box;
}

void RegionStore::findWhole(const glm::ivec3& blocks, const Effort& effort) {
  m_whole.resize(m_blocks.size());
  std::transform(m_blocks.begin(), m_blocks.end(), m_whole.begin(), [](BlockWeight weight) {
    return weight == BlockWeight::all ? farthestBlock : std::uint8_t{0};
  });
  spreadDistances(blocks, m_whole, effort);
}

} // namespace limn::cpu
