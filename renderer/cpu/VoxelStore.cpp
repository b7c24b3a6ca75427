// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/VoxelStore.h"

#include "scene/basics/Error.h"
#include "scene/function/PiecewiseTable.h"
#include "scene/steps/BlockGatherer.h"
#include "scene/volume/RowPieces.h"

#include <algorithm>
#include <limits>

namespace limn::cpu {
namespace {

// Offsets within a slice are 32-bit numbers that count from its middle.
constexpr std::size_t mostSliceBytes = std::size_t{1} << 32;

// By how much the largest stored number may exceed the width of the range before floats lose too much of it.
constexpr double mostMagnitude = 16.0;

template <class T>
constexpr bool isNarrow = sizeof(T) <= 2;

template <class T>
bool canStayAsStored(const Volume& volume) {
  if constexpr (!isNarrow<T>)
    return false;
  const ValueRange& range = volume.range();
  const Rescale& rescale = volume.rescale();
  const double a = (range.lowest - rescale.intercept) / rescale.slope;
  const double b = (range.highest - rescale.intercept) / rescale.slope;
  const double most = std::max(std::abs(a), std::abs(b));
  return std::isfinite(a) && std::isfinite(b) && std::abs(a - b) * mostMagnitude >= most;
}

template <class T>
constexpr VoxelSource::Kind
    kindOf = std::is_signed_v<T>
                 ? (sizeof(T) == 1 ? VoxelSource::Kind::signedByte : VoxelSource::Kind::signedHalf)
                 : (sizeof(T) == 1 ? VoxelSource::Kind::byte : VoxelSource::Kind::half);

template <class T>
VoxelSource asStored(const std::vector<T>& stored, const Volume& volume) {
  VoxelSource source;
  source.kind = kindOf<T>;
  source.begin = reinterpret_cast<const unsigned char*>(stored.data());
  source.bytes = static_cast<std::int64_t>(stored.size() * sizeof(T));
  const Rescale& rescale = volume.rescale();
  const auto normalised = [&](double voxel) {
    return normalisedValue(volume.range(), rescale.slope * voxel + rescale.intercept);
  };
  source.shift = static_cast<float>(normalised(0.0));
  source.scale = static_cast<float>((normalised(65536.0) - normalised(0.0)) / 65536.0);
  return source;
}

template <class T>
void copyNormalised(const std::vector<T>& stored, const Volume& volume, const Effort& effort,
                    std::vector<float>& floats) {
  floats.resize(stored.size());
  const std::size_t pieces = (stored.size() + voxelsPerPiece - 1) / voxelsPerPiece;
  const Rescale rescale = volume.rescale();
  const ValueRange range = volume.range();
  forEachPiece(static_cast<int>(pieces), effort, [&](int piece) {
    const std::size_t from = static_cast<std::size_t>(piece) * voxelsPerPiece;
    const std::size_t to = std::min(from + voxelsPerPiece, stored.size());
    for (std::size_t n = from; n < to; ++n)
      floats[n] = static_cast<float>(
          normalisedValue(range, rescale.slope * static_cast<double>(stored[n]) + rescale.intercept));
  });
}

// Lowest and highest normalised scalar of each block, the voxels on its faces included.
template <class T>
UninitialisedVector<glm::vec2> gatherBlocks(const T* voxels, const glm::ivec3& dims,
                                            const Rescale& toNormalised, const Effort& effort) {
  const glm::ivec3 blocks = blocksOf(dims);
  UninitialisedVector<glm::vec2> result(static_cast<std::size_t>(blocks.x) * blocks.y * blocks.z);
  const RowPieces rows(blocks, blockSize * blockSize * blockSize);
  shareOut(rows.pieces(), effort, [&](Pieces& pieces) {
    BlockGatherer<T> gatherer(dims);
    for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
      rows.forEachRow(piece, [&](int j, int k) {
        gatherer.gather(j, k, [&](int y, int z) { return voxels + voxelOffset(dims, 0, y, z); });
        glm::vec2* ranges = &result[voxelOffset(blocks, 0, j, k)];
        for (int i = 0; i < blocks.x; ++i) {
          const double a =
              toNormalised.slope * static_cast<double>(gatherer.lowest(i)) + toNormalised.intercept;
          const double b =
              toNormalised.slope * static_cast<double>(gatherer.highest(i)) + toNormalised.intercept;
          ranges[i] = {std::min(a, b), std::max(a, b)};
        }
      });
  });
  return result;
}

template <class T>
void requireRoom(const Volume& volume) {
  const std::size_t each = canStayAsStored<T>(volume) ? sizeof(T) : sizeof(float);
  const glm::ivec3 dims = volume.grid().dims;
  if (static_cast<std::size_t>(dims.x) * static_cast<std::size_t>(dims.y) > mostSliceBytes / each)
    throw Error(Error::Kind::input,
                Message::tr("A slice of the volume takes more than 4 GiB, which the CPU engine does not "
                            "draw; draw a part of it or a reduced copy."));
}

} // namespace

VoxelStore::VoxelStore(std::shared_ptr<const Volume> volume, const Effort& effort)
    : m_volume(std::move(volume)) {
  const glm::ivec3 dims = m_volume->grid().dims;
  // Rounding moves a position in a volume so large by less than a quarter of this.
  const float margin = static_cast<float>(std::max({dims.x, dims.y, dims.z})) * 0x1p-20f;
  visitVoxels(*m_volume, [&]<class T>(const std::vector<T>& stored) {
    requireRoom<T>(*m_volume);
    if (canStayAsStored<T>(*m_volume)) {
      m_source = asStored(stored, *m_volume);
      m_blocks = widenedByNeighbours(
          blocksOf(dims), gatherBlocks(stored.data(), dims, {m_source.scale, m_source.shift}, effort), margin,
          effort);
      return;
    }
    copyNormalised(stored, *m_volume, effort, m_floats);
    m_source.kind = VoxelSource::Kind::single;
    m_source.begin = reinterpret_cast<const unsigned char*>(m_floats.data());
    m_source.bytes = static_cast<std::int64_t>(m_floats.size() * sizeof(float));
    m_blocks = widenedByNeighbours(blocksOf(dims), gatherBlocks(m_floats.data(), dims, {1.0, 0.0}, effort),
                                   margin, effort);
  });
  const std::int64_t voxelBytes = m_source.bytes / (std::int64_t{dims.x} * dims.y * dims.z);
  m_source.dims = dims;
  const std::int64_t row = voxelBytes * dims.x;
  m_source.strideY = dims.y > 1 ? row : 0;
  m_source.strideZ = dims.z > 1 ? row * dims.y : 0;
}

std::size_t VoxelStore::ownBytes() const {
  return m_floats.size() * sizeof(float) + m_blocks.bytes();
}

} // namespace limn::cpu
