// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/VoxelStore.h"

#include "scene/basics/Error.h"
#include "scene/function/PiecewiseTable.h"
#include "scene/steps/BlockGatherer.h"
#include "scene/volume/RowPieces.h"
#include "scene/volume/VolumePart.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <type_traits>

namespace limn::cpu {
namespace {

// Rays number rows along x in 32 bits, and bytes within one (simd/Field-inl.h).
constexpr std::int64_t mostRows = std::int64_t{1} << 30;
constexpr std::int64_t mostRowBytes = std::int64_t{1} << 30;

// By how much the largest stored number may exceed the width of the range before floats lose too much of it.
constexpr double mostMagnitude = 16.0;

// Ranges of floats whose squares are floats, too, and their reciprocals.
constexpr double leastFloatRange = 1e-15;
constexpr double mostFloatRange = 1e15;

template <class T>
constexpr bool isReadable = sizeof(T) <= 2 || std::is_same_v<T, float>;

template <class T>
bool canStayAsStored(const Volume& volume) {
  if constexpr (!isReadable<T>)
    return false;
  const ValueRange& range = volume.range();
  const Rescale& rescale = volume.rescale();
  const double a = (range.lowest - rescale.intercept) / rescale.slope;
  const double b = (range.highest - rescale.intercept) / rescale.slope;
  const double most = std::max(std::abs(a), std::abs(b));
  // In memory a copy costs little, and keeps pictures of the same multiples of any number the same.
  if (std::is_floating_point_v<T> &&
      !(volume.room() && std::abs(a - b) >= leastFloatRange && std::abs(a - b) <= mostFloatRange))
    return false;
  return std::isfinite(a) && std::isfinite(b) && std::abs(a - b) * mostMagnitude >= most;
}

template <class T>
constexpr VoxelSource::Kind
    kindOf = std::is_floating_point_v<T> ? VoxelSource::Kind::single
             : std::is_signed_v<T>
                 ? (sizeof(T) == 1 ? VoxelSource::Kind::signedByte : VoxelSource::Kind::signedHalf)
                 : (sizeof(T) == 1 ? VoxelSource::Kind::byte : VoxelSource::Kind::half);

template <class T>
VoxelSource asStored(const StoredVoxels<T>& stored, const Volume& volume) {
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

// The voxels of a volume that lie in its array.
VoxelBox heldOf(const Volume& volume) {
  return volume.part() ? volume.part()->box : allVoxels(volume.grid());
}

// Where a voxel lies in an array of those that are held.
std::size_t placeIn(const VoxelBox& held, int x, int y, int z) {
  return voxelOffset(held.upper - held.lower, x - held.lower.x, y - held.lower.y, z - held.lower.z);
}

template <class T>
void copyNormalised(const StoredVoxels<T>& stored, const Volume& volume, const VoxelBox& box,
                    const Effort& effort, RoomVector<float>& floats) {
  floats = RoomVector<float>(stored.size(), volume.room());
  const VoxelBox held = heldOf(volume);
  const RowPieces rows(box.upper - box.lower);
  const Rescale rescale = volume.rescale();
  const ValueRange range = volume.range();
  forEachPiece(rows.pieces(), effort, [&](int piece) {
    rows.forEachRow(piece, [&](int j, int k) {
      const std::size_t first = placeIn(held, box.lower.x, box.lower.y + j, box.lower.z + k);
      const std::size_t end = first + static_cast<std::size_t>(box.upper.x - box.lower.x);
      for (std::size_t n = first; n < end; ++n)
        floats[n] = static_cast<float>(
            normalisedValue(range, rescale.slope * static_cast<double>(stored[n]) + rescale.intercept));
    });
  });
}

// Writes lowest and highest normalised scalar of each block in some planes of a part, the voxels on its faces
// included. Planes count from the part's first.
template <class T>
void gatherPlanes(const T* voxels, const VoxelBox& held, const glm::ivec3& dims, const BlockBox& part,
                  const Rescale& toNormalised, int first, int end, glm::vec2* result, const Effort& effort) {
  const glm::ivec3 blocks = part.upper - part.lower;
  // A row is looked at where it is the part's alone.
  const VoxelBox box = voxelsOf(part, dims);
  const glm::ivec3 inRows(box.upper.x - box.lower.x, dims.y, dims.z);
  const RowPieces rows({blocks.x, blocks.y, end - first}, blockSize * blockSize * blockSize);
  shareOut(rows.pieces(), effort, [&](Pieces& pieces) {
    BlockGatherer<T> gatherer(inRows);
    for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
      rows.forEachRow(piece, [&](int j, int k) {
        gatherer.gather(part.lower.y + j, part.lower.z + first + k,
                        [&](int y, int z) { return voxels + placeIn(held, box.lower.x, y, z); });
        glm::vec2* ranges = result + voxelOffset(blocks, 0, j, k);
        for (int i = 0; i < blocks.x; ++i) {
          const double a =
              toNormalised.slope * static_cast<double>(gatherer.lowest(i)) + toNormalised.intercept;
          const double b =
              toNormalised.slope * static_cast<double>(gatherer.highest(i)) + toNormalised.intercept;
          ranges[i] = {std::min(a, b), std::max(a, b)};
        }
      });
  });
}

template <class T>
BlockRanges blocksOfVoxels(const T* voxels, const Volume& volume, const BlockBox& part,
                           const Rescale& toNormalised, const Effort& effort) {
  const glm::ivec3& dims = volume.grid().dims;
  const VoxelBox held = heldOf(volume);
  // Rounding moves a position in a volume so large by less than a quarter of this.
  const float margin = static_cast<float>(std::max({dims.x, dims.y, dims.z})) * 0x1p-20f;
  const GatherPlanes gather = [&](int first, int end, glm::vec2* ranges, const Effort& planes) {
    gatherPlanes(voxels, held, dims, part, toNormalised, first, end, ranges, planes);
  };
  return widenedByNeighbours(part.upper - part.lower, gather, margin, effort, volume.room());
}

void requireCountable(const glm::ivec3& dims) {
  if (std::int64_t{dims.y} * dims.z > mostRows ||
      std::int64_t{dims.x} * std::int64_t{sizeof(float)} > mostRowBytes)
    throw Error(
        Error::Kind::input,
        Message::tr("The volume has more rows, or longer ones, than the CPU engine counts: it draws up "
                    "to %1 rows of %2 voxels; draw a part of it or a reduced copy.")
            .arg(mostRows)
            .arg(mostRowBytes / std::int64_t{sizeof(float)}));
}

} // namespace

VoxelBox voxelsOf(const BlockBox& part, const glm::ivec3& dims) {
  return {part.lower * blockSize, glm::min(part.upper * blockSize + 1, dims)};
}

VoxelStore::VoxelStore(std::shared_ptr<const Volume> volume, const BlockBox& part, const Effort& effort,
                       bool asFloats)
    : m_volume(std::move(volume)), m_part(part) {
  const VoxelBox read = voxelsOf(part, m_volume->grid().dims);
  const VoxelBox held = heldOf(*m_volume);
  assert(contains(held, read));
  requireCountable(m_volume->grid().dims);
  const auto store = [&]<class T>(const StoredVoxels<T>& stored) {
    if (!asFloats && canStayAsStored<T>(*m_volume)) {
      m_source = asStored(stored, *m_volume);
      m_blocks = blocksOfVoxels(stored.data(), *m_volume, part, {m_source.scale, m_source.shift}, effort);
      return;
    }
    copyNormalised(stored, *m_volume, read, partOf(effort, 0.0, 0.5), m_floats);
    m_source.kind = VoxelSource::Kind::single;
    m_source.begin = reinterpret_cast<const unsigned char*>(m_floats.data());
    m_source.bytes = static_cast<std::int64_t>(m_floats.size() * sizeof(float));
    m_blocks = blocksOfVoxels(m_floats.data(), *m_volume, part, {1.0, 0.0}, partOf(effort, 0.5, 1.0));
  };
  std::visit(store, m_volume->stored());
  const glm::ivec3 dims = held.upper - held.lower;
  const std::int64_t voxelBytes = m_source.bytes / (std::int64_t{dims.x} * dims.y * dims.z);
  m_source.first = held.lower;
  m_source.dims = dims;
  const std::int64_t row = voxelBytes * dims.x;
  m_source.strideY = dims.y > 1 ? row : 0;
  m_source.strideZ = dims.z > 1 ? row * dims.y : 0;
  // Voxels are found by their indices in the whole.
  const std::int64_t before =
      voxelBytes * held.lower.x + row * (held.lower.y + std::int64_t{dims.y} * held.lower.z);
  m_source.begin -= before;
  m_source.bytes += before;
}

std::size_t VoxelStore::ownBytes() const {
  if (m_volume->room())
    return 0;
  const VoxelBox box = voxelsOf(m_part, m_volume->grid().dims);
  const glm::ivec3 copied = m_floats.empty() ? glm::ivec3(0) : box.upper - box.lower;
  return static_cast<std::size_t>(copied.x) * copied.y * copied.z * sizeof(float) + m_blocks.bytes();
}

} // namespace limn::cpu
