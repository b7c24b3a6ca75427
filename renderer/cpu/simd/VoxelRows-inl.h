// SPDX-License-Identifier: GPL-3.0-or-later
// The voxels around one sample, four neighbours along x at a time: those from which its scalar and its
// gradient are interpolated.
#if defined(LIMN_CPU_VOXEL_ROWS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_VOXEL_ROWS_INL_H
#undef LIMN_CPU_VOXEL_ROWS_INL_H
#else
#define LIMN_CPU_VOXEL_ROWS_INL_H
#endif

#include "cpu/rays/PictureTerms.h"
#include "cpu/simd/Math-inl.h"

#include <algorithm>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

using Four = hn::FixedTag<float, 4>;
using F4 = hn::Vec<Four>;
inline constexpr Four four;

template <VoxelSource::Kind kind>
inline constexpr bool isSigned =
    kind == VoxelSource::Kind::signedByte || kind == VoxelSource::Kind::signedHalf;

/// Of one stored voxel.
template <VoxelSource::Kind kind>
inline constexpr int bytesOf = kind == VoxelSource::Kind::single                                          ? 4
                               : kind == VoxelSource::Kind::half || kind == VoxelSource::Kind::signedHalf ? 2
                                                                                                          : 1;

/// The type in which voxels are stored.
template <VoxelSource::Kind kind>
using Stored = std::conditional_t<
    bytesOf<kind> == 4, float,
    std::conditional_t<bytesOf<kind> == 2, std::conditional_t<isSigned<kind>, std::int16_t, std::uint16_t>,
                       std::conditional_t<isSigned<kind>, std::int8_t, std::uint8_t>>>;

/// Four neighbours along x, as they are stored.
template <VoxelSource::Kind kind>
using StoredRow = hn::Vec<hn::FixedTag<Stored<kind>, 4>>;

template <VoxelSource::Kind kind>
HWY_INLINE StoredRow<kind> storedRowAt(const unsigned char* first) {
  return hn::LoadU(hn::FixedTag<Stored<kind>, 4>(), reinterpret_cast<const Stored<kind>*>(first));
}

/// As many stored numbers as floats.
template <VoxelSource::Kind kind, class D, class V>
HWY_INLINE hn::Vec<D> asFloats(D d, V stored) {
  if constexpr (kind == VoxelSource::Kind::single)
    return stored;
  else
    return hn::ConvertTo(d, hn::PromoteTo(hn::RebindToSigned<D>(), stored));
}

/// The rows around a cell that has two voxels more on either side of every axis: at y, z in -1 … 2 from it,
/// the voxels at x in -1 … 2.
template <VoxelSource::Kind kind>
class InnerRows {
public:
  /// Of the voxel before the cell along x.
  HWY_INLINE InnerRows(const unsigned char* before, std::int64_t strideY, std::int64_t strideZ)
      : m_strideY(strideY), m_slices{before - strideZ, before, before + strideZ, before + 2 * strideZ} {}

  HWY_INLINE F4 at(int y, int z) const { return asFloats<kind>(four, storedAt(y, z)); }

  HWY_INLINE StoredRow<kind> storedAt(int y, int z) const {
    return storedRowAt<kind>(m_slices[z + 1] + y * m_strideY);
  }

private:
  std::int64_t m_strideY;
  const unsigned char* m_slices[4];
};

/// The rows around two such cells, side by side.
template <VoxelSource::Kind kind, class Eight>
class InnerPairs {
public:
  HWY_INLINE InnerPairs(const InnerRows<kind>& first, const InnerRows<kind>& second)
      : m_first(first), m_second(second) {}

  HWY_INLINE hn::Vec<Eight> at(int y, int z) const {
    const hn::Rebind<Stored<kind>, Eight> narrow;
    return asFloats<kind>(Eight(), hn::Combine(narrow, m_second.storedAt(y, z), m_first.storedAt(y, z)));
  }

private:
  InnerRows<kind> m_first, m_second;
};

/// Likewise for any cell. Beyond the volume's border the field goes on as a line, which makes the central
/// difference there the one-sided one; along an axis of one voxel it stays.
template <VoxelSource::Kind kind>
class OuterRows {
public:
  OuterRows(const VoxelSource& voxels, const glm::ivec3& cell) : m_voxels(voxels), m_cell(cell) {}

  HWY_NOINLINE F4 at(int y, int z) const { return rowOf(m_cell.y + y, m_cell.z + z); }

private:
  // The voxel of an axis at an index or at the border before it, and the one before that.
  static int inside(int index, int first, int last) { return std::clamp(index, first, last); }
  static int inner(int index, int first, int last) { return index < first ? first + 1 : last - 1; }

  F4 rowOf(int y, int z) const {
    const glm::ivec3 first = m_voxels.first;
    const glm::ivec3 last = first + m_voxels.dims - 1;
    if (last.z > first.z && (z < first.z || z > last.z))
      return beyond(rowOf(y, inside(z, first.z, last.z)), rowOf(y, inner(z, first.z, last.z)));
    if (last.y > first.y && (y < first.y || y > last.y))
      return beyond(rowOf(inside(y, first.y, last.y), z), rowOf(inner(y, first.y, last.y), z));
    const unsigned char* row = m_voxels.begin + inside(y, first.y, last.y) * m_voxels.strideY +
                               inside(z, first.z, last.z) * m_voxels.strideZ;
    if (m_cell.x > first.x && m_cell.x + 2 <= last.x)
      return asFloats<kind>(four, storedRowAt<kind>(row + std::int64_t{m_cell.x - 1} * bytesOf<kind>));
    HWY_ALIGN float numbers[4];
    for (int x = -1; x < 3; ++x)
      numbers[x + 1] = numberOf(row, m_cell.x + x, first.x, last.x);
    return hn::Load(four, numbers);
  }

  HWY_INLINE static F4 beyond(F4 border, F4 before) { return hn::Sub(hn::Add(border, border), before); }

  static float numberOf(const unsigned char* row, int x, int first, int last) {
    const auto* stored = reinterpret_cast<const Stored<kind>*>(row);
    const auto border = static_cast<float>(stored[inside(x, first, last)]);
    return last == first || (x >= first && x <= last)
               ? border
               : 2.0f * border - static_cast<float>(stored[inner(x, first, last)]);
  }

  const VoxelSource& m_voxels;
  glm::ivec3 m_cell;
};

/// What the rows around a sample make at its y and z, at each of the four x: the field, and what it gains
/// over two voxels along y and z. Of two samples where registers hold eight numbers.
/// What rows come to: interpolated across them, and how much that gains along y and z.
template <class V>
struct RowSums {
  V along, slopeY, slopeZ;
};

/// From `a` where the weight `w` is 0 to `b` where it is 1.
template <class V>
HWY_INLINE V mixed(V a, V b, V w) {
  return hn::MulAdd(w, hn::Sub(b, a), a);
}

/// `Rows` has the rows at y, z in -1 … 2; `y` and `z` are the weights between 0 and 1.
template <class V, class Rows>
HWY_INLINE RowSums<V> summed(const Rows& rows, V y, V z) {
  const V row00 = rows.at(0, 0), row10 = rows.at(1, 0), row01 = rows.at(0, 1), row11 = rows.at(1, 1);
  const V at0 = mixed(row00, row01, z);
  const V at1 = mixed(row10, row11, z);
  const V before = mixed(rows.at(-1, 0), rows.at(-1, 1), z);
  const V behind = mixed(rows.at(2, 0), rows.at(2, 1), z);
  RowSums<V> sums;
  sums.along = mixed(at0, at1, y);
  sums.slopeY = mixed(hn::Sub(at1, before), hn::Sub(behind, at0), y);
  const V slope0 = mixed(hn::Sub(row01, rows.at(0, -1)), hn::Sub(rows.at(0, 2), row00), z);
  const V slope1 = mixed(hn::Sub(row11, rows.at(1, -1)), hn::Sub(rows.at(1, 2), row10), z);
  sums.slopeZ = mixed(slope0, slope1, y);
  return sums;
}

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
