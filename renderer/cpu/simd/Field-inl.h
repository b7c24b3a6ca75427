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
#include "cpu/simd/VoxelRows-inl.h"

#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// The eight voxels around each sample and its weights between them.
struct Cells {
  VI x, y, z;
  V3 weight;
};

/// A voxel interpolated and what it gains over two voxels along each axis of the grid.
struct VoxelAndSlope {
  VF voxel;
  V3 slope;
};

/// The scalar field between voxels, several places at a time (DEFINITION section 1).
template <VoxelSource::Kind kind>
class Field {
public:
  explicit Field(const VoxelSource& voxels)
      : m_voxels(voxels), m_rowBytes(std::int64_t{bytesOf<kind>} * voxels.dims.x),
        m_rowsAhead((voxels.dims.y > 1 ? 1 : 0) + (voxels.dims.z > 1 ? voxels.dims.y : 0)),
        m_lastSafeRow(
            static_cast<std::int32_t>(std::int64_t{voxels.dims.y} * (voxels.first.z + voxels.dims.z) +
                                      voxels.first.y - 1 - (3 + m_rowBytes - 1) / m_rowBytes)) {}

  /// The cells of continuous voxel indices, clamped to the outermost voxel centres.
  HWY_INLINE Cells cellsAt(const V3& index) const {
    // Voxels as they are stored pay nothing for the question.
    if constexpr (kind == VoxelSource::Kind::single)
      if (HWY_UNLIKELY(m_voxels.roundsPlaces))
        return cellsAround({rounded(index.x), rounded(index.y), rounded(index.z)});
    return cellsAround(index);
  }

  /// Normalised scalars at continuous voxel indices.
  HWY_NOINLINE VF scalarAt(const V3& index) const { return normalised(voxelAt(index)); }

  /// The same as voxels are stored.
  HWY_INLINE VF voxelAt(const V3& index) const {
    const Cells cells = cellsAt(index);
    VF first[4], second[4];
    cornersOf(cells, first, second);
    // In the order of VoxelRows-inl.h: both give the same bits.
    const V3& w = cells.weight;
    return mix(mix(mix(first[0], first[2], w.z), mix(first[1], first[3], w.z), w.y),
               mix(mix(second[0], second[2], w.z), mix(second[1], second[3], w.z), w.y), w.x);
  }

  /// The normalised voxels at the eight corners of the cells around continuous voxel indices, and what share
  /// of the place each has.
  HWY_INLINE void cornersAt(const V3& index, VF corner[8], VF share[8]) const {
    const Cells cells = cellsAt(index);
    VF first[4], second[4];
    cornersOf(cells, first, second);
    const V3& w = cells.weight;
    const VF x = hn::Sub(all(1.0f), w.x), y = hn::Sub(all(1.0f), w.y), z = hn::Sub(all(1.0f), w.z);
    const VF across[4] = {hn::Mul(y, z), hn::Mul(w.y, z), hn::Mul(y, w.z), hn::Mul(w.y, w.z)};
    for (int row = 0; row < 4; ++row) {
      corner[2 * row] = normalised(first[row]);
      corner[2 * row + 1] = normalised(second[row]);
      share[2 * row] = hn::Mul(x, across[row]);
      share[2 * row + 1] = hn::Mul(w.x, across[row]);
    }
  }

  /// The normalised scalars along chords between two continuous voxel indices, each within a cell: cubics, by
  /// their Bernstein coefficients, which are the means of the field's polar form at the chord's ends.
  HWY_NOINLINE void cubicsAlong(const V3& from, const V3& to, VF cubic[4]) const {
    const VF half = all(0.5f);
    const Cells cells = cellsAt({hn::Mul(half, hn::Add(from.x, to.x)), hn::Mul(half, hn::Add(from.y, to.y)),
                                 hn::Mul(half, hn::Add(from.z, to.z))});
    VF first[4], second[4];
    cornersOf(cells, first, second);
    const V3 a = weightsIn(cells, from);
    const V3 b = weightsIn(cells, to);
    // At the chord's begin or end along y and z, each at the voxels along x.
    const Across low = across(first, a, b), high = across(second, a, b);
    const VF begin = mix(low.beginBegin, high.beginBegin, a.x);
    const VF end = mix(low.endEnd, high.endEnd, b.x);
    const VF third = all(1.0f / 3.0f);
    const VF nearBegin = hn::Add(hn::Sub(mix(low.beginBegin, high.beginBegin, b.x), begin),
                                 hn::Add(hn::Sub(mix(low.endBegin, high.endBegin, a.x), begin),
                                         hn::Sub(mix(low.beginEnd, high.beginEnd, a.x), begin)));
    const VF nearEnd = hn::Add(hn::Sub(mix(low.endEnd, high.endEnd, a.x), end),
                               hn::Add(hn::Sub(mix(low.endBegin, high.endBegin, b.x), end),
                                       hn::Sub(mix(low.beginEnd, high.beginEnd, b.x), end)));
    cubic[0] = normalised(begin);
    cubic[1] = normalised(hn::MulAdd(third, nearBegin, begin));
    cubic[2] = normalised(hn::MulAdd(third, nearEnd, end));
    cubic[3] = normalised(end);
  }

  HWY_INLINE VF normalised(VF voxel) const {
    return hn::MulAdd(voxel, all(m_voxels.scale), all(m_voxels.shift));
  }

  /// The first `count` of some samples with the gradient of the field, voxel gradients interpolated
  /// trilinearly; 0 for the others.
  HWY_NOINLINE VoxelAndSlope voxelAndSlopeAt(const V3& index, int count) const {
    const Cells cells = cellsAt(index);
    Sums sums;
    HWY_ALIGN std::int32_t bytes[most], rowsOf[most];
    const Places places = placesOf(cells);
    hn::Store(places.bytes, ints, bytes);
    hn::Store(places.row, ints, rowsOf);
    // Copies: the compiler cannot know that what is stored below does not change them.
    const std::int64_t strideY = m_voxels.strideY, strideZ = m_voxels.strideZ, rowBytes = m_rowBytes;
    const unsigned char* firstVoxel = m_voxels.begin - bytesOf<kind>;
    const std::uint32_t inner = bitsOf(hn::RebindMask(floats, isInner(cells)));
    int lane = 0;
    if constexpr (hn::MaxLanes(floats) == 8) {
      // Two at a time where both are inside.
      for (; lane + 1 < count && (inner >> lane & 3u) == 3u; lane += 2) {
        const InnerPairs<kind, Floats> rows(
            {firstVoxel + rowsOf[lane] * rowBytes + bytes[lane], strideY, strideZ},
            {firstVoxel + rowsOf[lane + 1] * rowBytes + bytes[lane + 1], strideY, strideZ});
        const auto lanesOf =
            hn::IndicesFromVec(floats, hn::Add(hn::Set(ints, lane), hn::ShiftRight<2>(hn::Iota(ints, 0))));
        sums.keep(floats, lane,
                  summed<VF>(rows, hn::TableLookupLanes(cells.weight.y, lanesOf),
                             hn::TableLookupLanes(cells.weight.z, lanesOf)));
      }
    }
    HWY_ALIGN float ys[most], zs[most];
    hn::Store(cells.weight.y, floats, ys);
    hn::Store(cells.weight.z, floats, zs);
    for (; lane < count; ++lane) {
      const F4 y = hn::Set(four, ys[lane]);
      const F4 z = hn::Set(four, zs[lane]);
      if (HWY_LIKELY((inner >> lane & 1u) != 0)) {
        const InnerRows<kind> rows(firstVoxel + rowsOf[lane] * rowBytes + bytes[lane], strideY, strideZ);
        sums.keep(four, lane, summed<F4>(rows, y, z));
      } else {
        const OuterRows<kind> rows(m_voxels,
                                   {lowAt(cells.x, lane), lowAt(cells.y, lane), lowAt(cells.z, lane)});
        sums.keep(four, lane, summed<F4>(rows, y, z));
      }
    }
    for (; lane < lanes(); ++lane)
      sums.keep(four, lane, RowSums<F4>{hn::Zero(four), hn::Zero(four), hn::Zero(four)});
    VoxelAndSlope result;
    VF before, first, second, behind;
    hn::LoadInterleaved4(floats, sums.along, before, first, second, behind);
    result.voxel = mix(first, second, cells.weight.x);
    result.slope.x = mix(hn::Sub(second, before), hn::Sub(behind, first), cells.weight.x);
    hn::LoadInterleaved4(floats, sums.slopeY, before, first, second, behind);
    result.slope.y = mix(first, second, cells.weight.x);
    hn::LoadInterleaved4(floats, sums.slopeZ, before, first, second, behind);
    result.slope.z = mix(first, second, cells.weight.x);
    return result;
  }

private:
  static constexpr int most = HWY_MAX_BYTES / 4;
  static constexpr int shift = bytesOf<kind> == 1 ? 0 : bytesOf<kind> == 2 ? 1 : 2;

  // Four numbers of each sample.
  struct Sums {
    template <class D>
    HWY_INLINE void keep(D d, int lane, const RowSums<hn::Vec<D>>& sum) {
      hn::Store(sum.along, d, along + 4 * lane);
      hn::Store(sum.slopeY, d, slopeY + 4 * lane);
      hn::Store(sum.slopeZ, d, slopeZ + 4 * lane);
    }

    HWY_ALIGN float along[4 * most], slopeY[4 * most], slopeZ[4 * most];
  };

  // The voxels with the smallest indices of each cell: which of all rows along x, and the bytes before it
  // there. A row is picked by a product of 64 bits, so that volumes and slices may take any number of bytes.
  struct Places {
    VI row, bytes;
  };

  HWY_INLINE Cells cellsAround(const V3& index) const {
    Cells cells;
    cells.x = lowOf(index.x, m_voxels.first.x, m_voxels.dims.x, cells.weight.x);
    cells.y = lowOf(index.y, m_voxels.first.y, m_voxels.dims.y, cells.weight.y);
    cells.z = lowOf(index.z, m_voxels.first.z, m_voxels.dims.z, cells.weight.z);
    return cells;
  }

  // Where a graphics card would filter in place of this (shaders/decisions/weights_of_8_bits.glsl).
  HWY_INLINE static VF rounded(VF place) {
    return hn::Mul(hn::Floor(hn::MulAdd(place, all(256.0f), all(0.5f))), all(1.0f / 256.0f));
  }

  HWY_INLINE static VI lowOf(VF index, int first, int dim, VF& weight) {
    const VF clampedIndex = clamped(index, static_cast<float>(first), static_cast<float>(first + dim - 1));
    const VF low = hn::Min(hn::Floor(clampedIndex), all(static_cast<float>(first + (dim > 1 ? dim - 2 : 0))));
    weight = hn::Sub(clampedIndex, low);
    return intOf(low);
  }

  // The voxels of some cells at the lower and the upper x, each at (y, z), (y+1, z), (y, z+1), (y+1, z+1).
  HWY_INLINE void cornersOf(const Cells& cells, VF first[4], VF second[4]) const {
    VW words4[4], next4[4];
    wordsOf(placesOf(cells), words4);
    if constexpr (kind == VoxelSource::Kind::single) {
      Places next = placesOf(cells);
      next.bytes = hn::Add(next.bytes, hn::Set(ints, m_voxels.dims.x > 1 ? 4 : 0));
      wordsOf(next, next4);
    }
    for (int row = 0; row < 4; ++row) {
      if constexpr (kind == VoxelSource::Kind::single) {
        first[row] = hn::BitCast(floats, words4[row]);
        second[row] = hn::BitCast(floats, next4[row]);
      } else {
        first[row] = numberIn<0>(words4[row]);
        second[row] = numberIn<1>(words4[row]);
      }
    }
  }

  // Where indices lie in cells, 0..1.
  HWY_INLINE V3 weightsIn(const Cells& cells, const V3& index) const {
    return {weightIn(cells.x, index.x, m_voxels.first.x, m_voxels.dims.x),
            weightIn(cells.y, index.y, m_voxels.first.y, m_voxels.dims.y),
            weightIn(cells.z, index.z, m_voxels.first.z, m_voxels.dims.z)};
  }

  HWY_INLINE static VF weightIn(VI low, VF index, int first, int dim) {
    const VF inside = clamped(index, static_cast<float>(first), static_cast<float>(first + dim - 1));
    return clamped(hn::Sub(inside, hn::ConvertTo(floats, low)), 0.0f, 1.0f);
  }

  // Interpolated along y (named first) and z with the weights of a chord's begin or end.
  struct Across {
    VF beginBegin, endBegin, beginEnd, endEnd;
  };

  HWY_INLINE static Across across(const VF corners[4], const V3& begin, const V3& end) {
    const VF low0 = mix(corners[0], corners[2], begin.z), low1 = mix(corners[1], corners[3], begin.z);
    const VF high0 = mix(corners[0], corners[2], end.z), high1 = mix(corners[1], corners[3], end.z);
    return {mix(low0, low1, begin.y), mix(low0, low1, end.y), mix(high0, high1, begin.y),
            mix(high0, high1, end.y)};
  }

  HWY_INLINE static int lowAt(VI low, int lane) {
    HWY_ALIGN std::int32_t lows[most];
    hn::Store(low, ints, lows);
    return lows[lane];
  }

  HWY_INLINE Places placesOf(const Cells& cells) const {
    return {hn::Add(hn::Mul(cells.z, hn::Set(ints, m_voxels.dims.y)), cells.y),
            hn::ShiftLeft<shift>(cells.x)};
  }

  // Cells with two voxels more on either side.
  HWY_INLINE hn::Mask<Ints> isInner(const Cells& cells) const {
    const VI one = hn::Set(ints, 1);
    const VI lowest = hn::Min(hn::Min(hn::Sub(cells.x, hn::Set(ints, m_voxels.first.x)),
                                      hn::Sub(cells.y, hn::Set(ints, m_voxels.first.y))),
                              hn::Sub(cells.z, hn::Set(ints, m_voxels.first.z)));
    const VI beyondX = hn::Sub(hn::Set(ints, m_voxels.first.x + m_voxels.dims.x - 2), cells.x);
    const VI beyondY = hn::Sub(hn::Set(ints, m_voxels.first.y + m_voxels.dims.y - 2), cells.y);
    const VI beyondZ = hn::Sub(hn::Set(ints, m_voxels.first.z + m_voxels.dims.z - 2), cells.z);
    return hn::Not(hn::Lt(hn::Min(lowest, hn::Min(hn::Min(beyondX, beyondY), beyondZ)), one));
  }

  // Four bytes from each place on, of the rows (y, z), (y+1, z), (y, z+1), (y+1, z+1). Where some would reach
  // beyond the voxels, those bytes read as 0: their voxels have no weight.
  HWY_INLINE void wordsOf(const Places& places, VW result[4]) const {
    HWY_ALIGN std::int32_t bytes[most], rowsOf[most];
    hn::Store(places.bytes, ints, bytes);
    hn::Store(places.row, ints, rowsOf);
    const unsigned char* first = m_voxels.begin;
    const std::int64_t rowBytes = m_rowBytes;
    const std::int64_t steps[4] = {0, m_voxels.strideY, m_voxels.strideZ,
                                   m_voxels.strideY + m_voxels.strideZ};
    const VI last = hn::Add(places.row, hn::Set(ints, m_rowsAhead));
    if (HWY_LIKELY(hn::AllFalse(ints, hn::Gt(last, hn::Set(ints, m_lastSafeRow))))) {
      const unsigned char* begins[most];
      for (std::size_t lane = 0; lane < hn::MaxLanes(ints); ++lane)
        begins[lane] = first + rowsOf[lane] * rowBytes + bytes[lane];
      for (int row = 0; row < 4; ++row) {
        HWY_ALIGN std::uint32_t read[most];
        for (std::size_t lane = 0; lane < hn::MaxLanes(ints); ++lane)
          std::memcpy(&read[lane], begins[lane] + steps[row], 4);
        result[row] = hn::Load(words, read);
      }
      return;
    }
    for (int row = 0; row < 4; ++row) {
      HWY_ALIGN std::uint32_t read[most] = {};
      for (int lane = 0; lane < lanes(); ++lane) {
        const std::int64_t at = rowsOf[lane] * rowBytes + bytes[lane] + steps[row];
        const std::int64_t rest = m_voxels.bytes - at;
        if (rest > 0)
          std::memcpy(&read[lane], first + at, static_cast<std::size_t>(std::min<std::int64_t>(rest, 4)));
      }
      result[row] = hn::Load(words, read);
    }
  }

  // The voxel at the begin of four bytes, or the one behind it.
  template <int voxel>
  HWY_INLINE static VF numberIn(VW word) {
    constexpr int bits = 8 * bytesOf<kind>;
    const VW atTop = hn::ShiftLeft<32 - bits - voxel * bits>(word);
    if constexpr (isSigned<kind>)
      return hn::ConvertTo(floats, hn::ShiftRight<32 - bits>(hn::BitCast(ints, atTop)));
    else
      return hn::ConvertTo(floats, hn::BitCast(ints, hn::ShiftRight<32 - bits>(atTop)));
  }

  const VoxelSource& m_voxels;
  std::int64_t m_rowBytes;
  std::int32_t m_rowsAhead;   // to the last row of a cell
  std::int32_t m_lastSafeRow; // from any place in it four bytes are voxels
};

/// What the field whose gradients count gains over two voxels along each axis at the first `count` of some
/// places (DEFINITION section 2).
template <VoxelSource::Kind kind>
HWY_INLINE V3 slopeAt(const PictureTerms& terms, const Field<kind>& field, const V3& index, int count) {
  if (HWY_LIKELY(!terms.effects.has(Effect::smoothNormals)))
    return field.voxelAndSlopeAt(index, count).slope;
  return Field<VoxelSource::Kind::single>(terms.smoothed).voxelAndSlopeAt(index, count).slope;
}

/// The same with the voxels there, which stay.
template <VoxelSource::Kind kind>
HWY_INLINE VoxelAndSlope voxelAndSlopeAt(const PictureTerms& terms, const Field<kind>& field, const V3& index,
                                         int count) {
  if (HWY_LIKELY(!terms.effects.has(Effect::smoothNormals)))
    return field.voxelAndSlopeAt(index, count);
  return {field.voxelAt(index), slopeAt(terms, field, index, count)};
}

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
