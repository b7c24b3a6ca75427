// SPDX-License-Identifier: GPL-3.0-or-later
// Trilinear scalars and gradients (DEFINITION sections 1 and 2) of several samples at once, from voxels in
// their stored type.
#if defined(LIMN_CPU_FIELD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_FIELD_INL_H
#undef LIMN_CPU_FIELD_INL_H
#else
#define LIMN_CPU_FIELD_INL_H
#endif

#include "cpu/rays/PictureTerms.h"
#include "cpu/simd/Math-inl.h"

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// The eight voxels around each sample and its weights between them.
struct Cells {
  VI offset; ///< bytes of the voxel with the smallest indices, from the middle of the voxels
  VI x, y, z;
  V3 weight;
};

/// Two voxels that are neighbours along x.
struct Pair {
  VF first, second;
};

template <VoxelSource::Kind kind>
class Field {
public:
  explicit Field(const VoxelSource& voxels)
      : m_voxels(voxels), m_half(voxels.bytes / 2), m_middle(voxels.begin + m_half),
        m_lastWord(static_cast<std::int32_t>(voxels.bytes - m_half - 4)) {}

  /// The cells of continuous voxel indices, clamped to the outermost voxel centres.
  HWY_INLINE Cells cellsAt(const V3& index) const {
    Cells cells;
    cells.x = lowOf(index.x, m_voxels.dims.x, cells.weight.x);
    cells.y = lowOf(index.y, m_voxels.dims.y, cells.weight.y);
    cells.z = lowOf(index.z, m_voxels.dims.z, cells.weight.z);
    const VI row = hn::Add(hn::Mul(cells.y, hn::Set(ints, m_voxels.strideY)),
                           hn::Mul(cells.z, hn::Set(ints, m_voxels.strideZ)));
    cells.offset = hn::Sub(hn::Add(row, hn::ShiftLeft<shift>(cells.x)),
                           hn::Set(ints, static_cast<std::int32_t>(static_cast<std::uint32_t>(m_half))));
    return cells;
  }

  /// What interpolating gives, in unsigned voxels; the rows along x serve the gradient as well.
  struct Rows {
    Pair pairs[4]; ///< (y, z), (y+1, z), (y, z+1), (y+1, z+1)
    VF along[4];   ///< interpolated along x
  };

  HWY_NOINLINE Rows rowsOf(const Cells& cells) const {
    Rows rows;
    const std::int32_t steps[4] = {0, m_voxels.strideY, m_voxels.strideZ,
                                   m_voxels.strideY + m_voxels.strideZ};
    for (int row = 0; row < 4; ++row) {
      rows.pairs[row] = pairAt(hn::Add(cells.offset, hn::Set(ints, steps[row])));
      rows.along[row] = mix(rows.pairs[row].first, rows.pairs[row].second, cells.weight.x);
    }
    return rows;
  }

  /// Normalised scalars.
  HWY_INLINE VF scalarOf(const Rows& rows, const Cells& cells) const {
    const VF voxel = mix(mix(rows.along[0], rows.along[1], cells.weight.y),
                         mix(rows.along[2], rows.along[3], cells.weight.y), cells.weight.z);
    return hn::MulAdd(voxel, all(m_voxels.scale), all(m_voxels.shift));
  }

  HWY_NOINLINE VF scalarAt(const V3& index) const {
    const Cells cells = cellsAt(index);
    return scalarOf(rowsOf(cells), cells);
  }

  /// Voxel gradients interpolated trilinearly, along the grid's axes; `perTwo` turns a difference over two
  /// voxels into the unit wanted.
  HWY_NOINLINE V3 gradientOf(const Rows& rows, const Cells& cells, const glm::vec3& perTwo) const {
    const glm::ivec3& dims = m_voxels.dims;
    V3 gradient = zero();
    if (dims.x > 1) {
      const Ends ends = endsAlong(cells.x, dims.x, 1 << shift);
      VF along[4];
      for (int row = 0; row < 4; ++row) {
        const std::int32_t step = (row & 1 ? m_voxels.strideY : 0) + (row & 2 ? m_voxels.strideZ : 0);
        const VI offset = hn::Add(cells.offset, hn::Set(ints, step));
        const VF before = voxelAt(hn::Add(offset, ends.before));
        const VF behind = voxelAt(hn::Add(offset, ends.behind));
        along[row] =
            slope(before, rows.pairs[row].first, rows.pairs[row].second, behind, ends, cells.weight.x);
      }
      gradient.x = hn::Mul(all(perTwo.x), mix(mix(along[0], along[1], cells.weight.y),
                                              mix(along[2], along[3], cells.weight.y), cells.weight.z));
    }
    if (dims.y > 1) {
      const Ends ends = endsAlong(cells.y, dims.y, m_voxels.strideY);
      VF along[2];
      for (int slice = 0; slice < 2; ++slice) {
        const VI offset = hn::Add(cells.offset, hn::Set(ints, slice * m_voxels.strideZ));
        along[slice] = slope(alongX(hn::Add(offset, ends.before), cells), rows.along[2 * slice],
                             rows.along[2 * slice + 1], alongX(hn::Add(offset, ends.behind), cells), ends,
                             cells.weight.y);
      }
      gradient.y = hn::Mul(all(perTwo.y), mix(along[0], along[1], cells.weight.z));
    }
    if (dims.z > 1) {
      const Ends ends = endsAlong(cells.z, dims.z, m_voxels.strideZ);
      VF along[2];
      for (int row = 0; row < 2; ++row) {
        const VI offset = hn::Add(cells.offset, hn::Set(ints, row * m_voxels.strideY));
        along[row] = slope(alongX(hn::Add(offset, ends.before), cells), rows.along[row], rows.along[row + 2],
                           alongX(hn::Add(offset, ends.behind), cells), ends, cells.weight.z);
      }
      gradient.z = hn::Mul(all(perTwo.z), mix(along[0], along[1], cells.weight.y));
    }
    return gradient;
  }

private:
  // Bytes of a voxel as a power of two.
  static constexpr int shift = kind == VoxelSource::Kind::byte ? 0 : kind == VoxelSource::Kind::half ? 1 : 2;

  // The voxels beyond a cell along an axis, relative to its first one, and how many voxels a difference at
  // either of its own spans.
  struct Ends {
    VI before, behind;
    VF atFirst, atSecond; // 1 for two voxels, 2 for one: at the border the difference is one-sided
  };

  HWY_INLINE static VI lowOf(VF index, int dim, VF& weight) {
    const VF clampedIndex = clamped(index, 0.0f, static_cast<float>(dim - 1));
    const VI low = hn::Min(hn::ConvertTo(ints, clampedIndex), hn::Set(ints, dim > 1 ? dim - 2 : 0));
    weight = hn::Sub(clampedIndex, hn::ConvertTo(floats, low));
    return low;
  }

  HWY_INLINE static Ends endsAlong(VI low, int dim, std::int32_t stride) {
    const auto hasBefore = hn::Gt(low, hn::Zero(ints));
    const auto hasBehind = hn::Lt(low, hn::Set(ints, dim - 2));
    const VI step = hn::Set(ints, stride);
    return {hn::IfThenElseZero(hasBefore, hn::Neg(step)), hn::Add(step, hn::IfThenElseZero(hasBehind, step)),
            hn::IfThenElse(hn::RebindMask(floats, hasBefore), all(1.0f), all(2.0f)),
            hn::IfThenElse(hn::RebindMask(floats, hasBehind), all(1.0f), all(2.0f))};
  }

  // The difference over two voxels at the first and at the second voxel of a cell, between them.
  HWY_INLINE static VF slope(VF before, VF first, VF second, VF behind, const Ends& ends, VF weight) {
    const VF atFirst = hn::Mul(hn::Sub(second, before), ends.atFirst);
    const VF atSecond = hn::Mul(hn::Sub(behind, first), ends.atSecond);
    return mix(atFirst, atSecond, weight);
  }

  HWY_INLINE VF alongX(VI offset, const Cells& cells) const {
    const Pair pair = pairAt(offset);
    return mix(pair.first, pair.second, cells.weight.x);
  }

  // Four bytes from each offset on. Where some would reach beyond the voxels, those bytes read as 0: their
  // voxels have no weight.
  HWY_INLINE VW wordsAt(VI offset) const {
    if (HWY_LIKELY(hn::AllFalse(ints, hn::Gt(offset, hn::Set(ints, m_lastWord))))) {
      HWY_ALIGN std::int32_t offsets[HWY_MAX_BYTES / 4];
      HWY_ALIGN std::uint32_t result[HWY_MAX_BYTES / 4];
      hn::Store(offset, ints, offsets);
      for (std::size_t lane = 0; lane < hn::MaxLanes(ints); ++lane)
        std::memcpy(&result[lane], m_middle + offsets[lane], 4);
      return hn::Load(words, result);
    }
    HWY_ALIGN std::int32_t offsets[HWY_MAX_BYTES / 4];
    HWY_ALIGN std::uint32_t result[HWY_MAX_BYTES / 4] = {};
    hn::Store(offset, ints, offsets);
    for (int lane = 0; lane < lanes(); ++lane) {
      const std::int64_t rest = m_voxels.bytes - m_half - offsets[lane];
      if (rest > 0)
        std::memcpy(&result[lane], m_middle + offsets[lane],
                    static_cast<std::size_t>(std::min<std::int64_t>(rest, 4)));
    }
    return hn::Load(words, result);
  }

  HWY_INLINE static VF converted(VW voxel) { return hn::ConvertTo(floats, hn::BitCast(ints, voxel)); }

  HWY_INLINE Pair pairAt(VI offset) const {
    if constexpr (kind == VoxelSource::Kind::single) {
      const VI next = hn::Set(ints, m_voxels.dims.x > 1 ? 4 : 0);
      return {voxelAt(offset), voxelAt(hn::Add(offset, next))};
    } else {
      const VW both = hn::Xor(wordsAt(offset), hn::Set(words, m_voxels.flip));
      if constexpr (kind == VoxelSource::Kind::half)
        return {converted(hn::And(both, hn::Set(words, 0xFFFFu))), converted(hn::ShiftRight<16>(both))};
      else
        return {converted(hn::And(both, hn::Set(words, 0xFFu))),
                converted(hn::And(hn::ShiftRight<8>(both), hn::Set(words, 0xFFu)))};
    }
  }

  HWY_INLINE VF voxelAt(VI offset) const {
    if constexpr (kind == VoxelSource::Kind::single)
      return hn::BitCast(floats, wordsAt(offset));
    else
      return pairAt(offset).first;
  }

  const VoxelSource& m_voxels;
  std::int64_t m_half; // offsets count from the middle: they reach over 4 GiB
  const unsigned char* m_middle;
  std::int32_t m_lastWord;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
