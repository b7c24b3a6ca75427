// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/VoxelStore.h"

#include "cpu/Threads.h"
#include "scene/basics/Error.h"

#include <algorithm>
#include <limits>

namespace limn::cpu {
namespace {

// Offsets within the voxels are 32-bit numbers that count from the middle.
constexpr std::size_t mostBytes = std::size_t{1} << 32;

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
void copyNormalised(const std::vector<T>& stored, const Volume& volume, int threads,
                    std::vector<float>& floats) {
  floats.resize(stored.size());
  const std::size_t piece = 1 << 16;
  const int pieces = static_cast<int>((stored.size() + piece - 1) / piece);
  const Rescale rescale = volume.rescale();
  const ValueRange range = volume.range();
  forEach(pieces, threads, [&](int i) {
    const std::size_t from = static_cast<std::size_t>(i) * piece;
    const std::size_t to = std::min(from + piece, stored.size());
    for (std::size_t n = from; n < to; ++n)
      floats[n] = static_cast<float>(
          normalisedValue(range, rescale.slope * static_cast<double>(stored[n]) + rescale.intercept));
  });
}

// Lowest and highest stored number of each block, the voxels on its faces included.
template <class T>
void gatherBlocks(const T* voxels, const glm::ivec3& dims, const Rescale& toNormalised, int threads,
                  BlockRanges& result) {
  const glm::ivec3 blocks = result.blocks;
  forEach(blocks.z, threads, [&](int k) {
    for (int j = 0; j < blocks.y; ++j)
      for (int i = 0; i < blocks.x; ++i) {
        const glm::ivec3 first = glm::ivec3(i, j, k) * blockSize;
        const glm::ivec3 last = glm::min(first + blockSize, dims - 1);
        T lowest = voxels[voxelOffset(dims, first.x, first.y, first.z)];
        T highest = lowest;
        for (int z = first.z; z <= last.z; ++z)
          for (int y = first.y; y <= last.y; ++y) {
            const T* row = voxels + voxelOffset(dims, 0, y, z);
            for (int x = first.x; x <= last.x; ++x) {
              lowest = std::min(lowest, row[x]);
              highest = std::max(highest, row[x]);
            }
          }
        const double a = toNormalised.slope * static_cast<double>(lowest) + toNormalised.intercept;
        const double b = toNormalised.slope * static_cast<double>(highest) + toNormalised.intercept;
        result.ranges[voxelOffset(blocks, i, j, k)] = {std::min(a, b), std::max(a, b)};
      }
  });
}

// Lets each range stand for positions a little beyond its block: there the neighbours' voxels weigh no more
// than the margin, along each of three axes.
void widen(BlockRanges& blocks, const glm::ivec3& dims, int threads) {
  // Rounding moves a position in a volume so large by less than a quarter of this.
  const float margin = static_cast<float>(std::max({dims.x, dims.y, dims.z})) * 0x1p-20f;
  const std::vector<glm::vec2> own = blocks.ranges;
  forEach(blocks.blocks.z, threads, [&](int k) {
    for (int j = 0; j < blocks.blocks.y; ++j)
      for (int i = 0; i < blocks.blocks.x; ++i) {
        const glm::ivec3 from = glm::max(glm::ivec3(i, j, k) - 1, glm::ivec3(0));
        const glm::ivec3 to = glm::min(glm::ivec3(i, j, k) + 1, blocks.blocks - 1);
        glm::vec2& range = blocks.ranges[voxelOffset(blocks.blocks, i, j, k)];
        glm::vec2 around = range;
        for (int z = from.z; z <= to.z; ++z)
          for (int y = from.y; y <= to.y; ++y)
            for (int x = from.x; x <= to.x; ++x) {
              const glm::vec2& near = own[voxelOffset(blocks.blocks, x, y, z)];
              around = {std::min(around.x, near.x), std::max(around.y, near.y)};
            }
        const float beyond = 3.0f * margin * (around.y - around.x);
        range = {std::max(range.x - beyond, around.x), std::min(range.y + beyond, around.y)};
      }
  });
}

template <class T>
void requireRoom(const Volume& volume) {
  const std::size_t each = canStayAsStored<T>(volume) ? sizeof(T) : sizeof(float);
  if (volume.voxelCount() > mostBytes / each)
    throw Error(
        Error::Kind::input,
        "The volume's voxels take more than 4 GiB, which the CPU engine does not draw; draw a part of it "
        "or a reduced copy.");
}

} // namespace

VoxelStore::VoxelStore(std::shared_ptr<const Volume> volume, int threads) : m_volume(std::move(volume)) {
  const glm::ivec3 dims = m_volume->grid().dims;
  const glm::ivec3 cells = glm::max(dims - 1, glm::ivec3(1));
  m_blocks.blocks = (cells + blockSize - 1) / blockSize;
  m_blocks.ranges.resize(static_cast<std::size_t>(m_blocks.blocks.x) * m_blocks.blocks.y * m_blocks.blocks.z);
  visitVoxels(*m_volume, [&]<class T>(const std::vector<T>& stored) {
    requireRoom<T>(*m_volume);
    if (canStayAsStored<T>(*m_volume)) {
      m_source = asStored(stored, *m_volume);
      gatherBlocks(stored.data(), dims, {m_source.scale, m_source.shift}, threads, m_blocks);
      return;
    }
    copyNormalised(stored, *m_volume, threads, m_floats);
    m_source.kind = VoxelSource::Kind::single;
    m_source.begin = reinterpret_cast<const unsigned char*>(m_floats.data());
    m_source.bytes = static_cast<std::int64_t>(m_floats.size() * sizeof(float));
    gatherBlocks(m_floats.data(), dims, {1.0, 0.0}, threads, m_blocks);
  });
  widen(m_blocks, dims, threads);
  const std::int64_t voxelBytes = m_source.bytes / (std::int64_t{dims.x} * dims.y * dims.z);
  m_source.dims = dims;
  const std::int64_t row = voxelBytes * dims.x;
  m_source.strideY = dims.y > 1 ? row : 0;
  m_source.strideZ = dims.z > 1 ? row * dims.y : 0;
}

std::size_t VoxelStore::ownBytes() const {
  return m_floats.size() * sizeof(float) + m_blocks.ranges.size() * sizeof(glm::vec2);
}

} // namespace limn::cpu
