// SPDX-License-Identifier: GPL-3.0-or-later
// What labels with looks of their own make of samples (DEFINITION section 10). A sample among voxels of one
// look alone is classified by that look; only where looks meet are the labels of its eight voxels read.
#if defined(LIMN_CPU_LOOKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_LOOKS_INL_H
#undef LIMN_CPU_LOOKS_INL_H
#else
#define LIMN_CPU_LOOKS_INL_H
#endif

#include "cpu/rays/PictureTerms.h"
#include "cpu/simd/Field-inl.h"
#include "cpu/simd/Function-inl.h"
#include "scene/steps/BlockRanges.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// The looks of a picture's labels, several samples at a time. What is found of a sample does not depend on
/// the others.
class Looks {
public:
  explicit Looks(const PictureTerms& terms)
      : m_terms(terms), m_looks(terms.looks), m_hasRegion(terms.effects.has(Effect::region)) {}

  bool areAny() const { return m_terms.effects.has(Effect::labelLooks); }

  /// What samples absorb.
  struct Mixed {
    Mask seen;     // where some look has an opacity, whatever the factor makes of it
    V3 color;      // if asked for
    VF extinction; // per length
  };

  /// Samples at continuous voxel indices with the scalars there, their opacities times `factor`.
  HWY_NOINLINE Mixed mixedAt(const V3& index, VF scalar, VF factor, Mask wanted, bool withColor) const {
    HWY_ALIGN float alone[most];
    const LookBits bits = looksAround(index, wanted, alone);
    if (std::has_single_bit(bits))
      return byOne(std::countr_zero(bits), index, scalar, factor, wanted, withColor);
    return bySeveral(bits, hn::Load(floats, alone), index, scalar, factor, wanted, withColor);
  }

private:
  static constexpr int most = HWY_MAX_BYTES / 4;
  static constexpr int mostFunctions = static_cast<int>(mostLooks) + 1;

  // The looks of the blocks in which the wanted samples lie. `alone` says the look of a sample whose block
  // has but one, else -1.
  HWY_INLINE LookBits looksAround(const V3& index, Mask wanted, float alone[most]) const {
    const VF perBlock = all(1.0f / blockSize);
    HWY_ALIGN std::int32_t x[most], y[most], z[most];
    hn::Store(blockOf(hn::Mul(index.x, perBlock), 0), ints, x);
    hn::Store(blockOf(hn::Mul(index.y, perBlock), 1), ints, y);
    hn::Store(blockOf(hn::Mul(index.z, perBlock), 2), ints, z);
    const std::uint32_t lanesWanted = bitsOf(wanted);
    LookBits any = 0;
    for (int lane = 0; lane < lanes(); ++lane) {
      alone[lane] = -1.0f;
      if ((lanesWanted >> lane & 1u) == 0)
        continue;
      const LookBits own = m_looks.ofBlocks[voxelOffset(m_looks.blocks, x[lane], y[lane], z[lane])];
      any |= own;
      if (std::has_single_bit(own))
        alone[lane] = static_cast<float>(std::countr_zero(own));
    }
    return any;
  }

  HWY_INLINE VI blockOf(VF place, int axis) const {
    const VI block = intOf(hn::Floor(place));
    const VI within = hn::Sub(block, hn::Set(ints, m_looks.firstBlock[axis]));
    return hn::Max(hn::Min(within, hn::Set(ints, m_looks.blocks[axis] - 1)), hn::Zero(ints));
  }

  HWY_INLINE Function functionOf(int look) const {
    const LookTerms::Look& one = m_looks.all[static_cast<std::size_t>(look)];
    return Function(*one.table, one.segments);
  }

  HWY_INLINE VF weightAt(const V3& index) const {
    return m_terms.region.kind == VoxelSource::Kind::byte
               ? Field<VoxelSource::Kind::byte>(m_terms.region).scalarAt(index)
               : Field<VoxelSource::Kind::half>(m_terms.region).scalarAt(index);
  }

  HWY_INLINE VF extinctionOf(int look, VF opacity, VF factor) const {
    return hn::Mul(minusLog1mOpacity(hn::Mul(opacity, factor)),
                   all(m_looks.all[static_cast<std::size_t>(look)].perUnit));
  }

  HWY_NOINLINE Mixed byOne(int look, const V3& index, VF scalar, VF factor, Mask wanted,
                           bool withColor) const {
    const Function function = functionOf(look);
    Mixed mixed{wanted, zero(), hn::Zero(floats)};
    VF opacity;
    mixed.seen = function.opacityWhereSeen(scalar, wanted, opacity);
    if (m_hasRegion && !hn::AllFalse(floats, mixed.seen)) {
      const VF weight = weightAt(index);
      opacity = hn::Mul(opacity, weight);
      mixed.seen = hn::And(mixed.seen, hn::Gt(weight, hn::Zero(floats)));
    }
    if (hn::AllFalse(floats, mixed.seen))
      return mixed;
    mixed.extinction = hn::IfThenElseZero(mixed.seen, extinctionOf(look, opacity, factor));
    if (withColor)
      mixed.color = function.colorAt(scalar, mixed.seen);
    return mixed;
  }

  // The eight voxels around each sample: their looks, and the shares of the sample that they have.
  struct Around {
    VF look[8], share[8], weight[8];
  };

  HWY_INLINE void lookAround(const V3& index, Around& around) const {
    const Field<VoxelSource::Kind::byte> looks(m_looks.voxels);
    looks.cornersAt(index, around.look, around.share);
    if (!m_hasRegion)
      return;
    if (m_terms.region.kind == VoxelSource::Kind::byte)
      Field<VoxelSource::Kind::byte>(m_terms.region).cornersAt(index, around.weight, around.share);
    else
      Field<VoxelSource::Kind::half>(m_terms.region).cornersAt(index, around.weight, around.share);
  }

  // s and s·W of one look.
  HWY_INLINE static void shareOf(const Around& around, VF look, bool hasRegion, VF& share, VF& weighed) {
    share = weighed = hn::Zero(floats);
    for (int corner = 0; corner < 8; ++corner) {
      const VF own = hn::IfThenElseZero(hn::Eq(around.look[corner], look), around.share[corner]);
      share = hn::Add(share, own);
      if (hasRegion)
        weighed = hn::MulAdd(own, around.weight[corner], weighed);
    }
  }

  HWY_NOINLINE Mixed bySeveral(LookBits bits, VF alone, const V3& index, VF scalar, VF factor, Mask wanted,
                               bool withColor) const {
    Mixed mixed{hn::Lt(all(0.0f), hn::Zero(floats)), zero(), hn::Zero(floats)};
    int looks[mostFunctions];
    VF opacities[mostFunctions];
    Mask seen[mostFunctions];
    int count = 0;
    for (; bits != 0; bits &= bits - 1) {
      const int look = std::countr_zero(bits);
      const Mask mayHave = hn::And(
          wanted, hn::Or(hn::Lt(alone, hn::Zero(floats)), hn::Eq(alone, all(static_cast<float>(look)))));
      seen[count] = functionOf(look).opacityWhereSeen(scalar, mayHave, opacities[count]);
      if (hn::AllFalse(floats, seen[count]))
        continue;
      looks[count++] = look;
      mixed.seen = hn::Or(mixed.seen, seen[count - 1]);
    }
    if (count == 0)
      return mixed;
    const Mask isAlone = hn::Ge(alone, hn::Zero(floats));
    // Where no look has been found to show, none of the eight voxels is asked for.
    const bool meets = !hn::AllFalse(floats, hn::AndNot(isAlone, mixed.seen));
    const VF ofAlone = m_hasRegion ? weightAt(index) : all(1.0f);
    Around around;
    if (meets)
      lookAround(index, around);
    mixed.seen = hn::Lt(all(0.0f), hn::Zero(floats));
    VF extinctions[mostFunctions];
    for (int i = 0; i < count; ++i) {
      VF share = all(1.0f), weight = ofAlone;
      if (meets) {
        VF met, weighed;
        shareOf(around, all(static_cast<float>(looks[i])), m_hasRegion, met, weighed);
        const VF safe = hn::IfThenElse(hn::Gt(met, hn::Zero(floats)), met, all(1.0f));
        share = hn::IfThenElse(isAlone, share, met);
        if (m_hasRegion)
          weight = hn::IfThenElse(isAlone, weight, hn::Div(weighed, safe));
      }
      seen[i] = hn::And(seen[i], hn::And(hn::Gt(share, hn::Zero(floats)), hn::Gt(weight, hn::Zero(floats))));
      const VF opacity = m_hasRegion ? hn::Mul(opacities[i], weight) : opacities[i];
      extinctions[i] = hn::IfThenElseZero(seen[i], hn::Mul(share, extinctionOf(looks[i], opacity, factor)));
      mixed.extinction = hn::Add(mixed.extinction, extinctions[i]);
      mixed.seen = hn::Or(mixed.seen, seen[i]);
    }
    if (!withColor || hn::AllFalse(floats, mixed.seen))
      return mixed;
    // Parts of the whole first, so that of one look alone the colour is its own to the last bit.
    const VF whole = hn::IfThenElse(hn::Gt(mixed.extinction, hn::Zero(floats)), mixed.extinction, all(1.0f));
    for (int i = 0; i < count; ++i) {
      if (hn::AllFalse(floats, seen[i]))
        continue;
      const VF part = hn::Div(extinctions[i], whole);
      const V3 color = functionOf(looks[i]).colorAt(scalar, seen[i]);
      mixed.color = {hn::MulAdd(part, hn::IfThenElseZero(seen[i], color.x), mixed.color.x),
                     hn::MulAdd(part, hn::IfThenElseZero(seen[i], color.y), mixed.color.y),
                     hn::MulAdd(part, hn::IfThenElseZero(seen[i], color.z), mixed.color.z)};
    }
    mixed.color = clamped(mixed.color, 0.0f, 1.0f);
    return mixed;
  }

  const PictureTerms& m_terms;
  const LookTerms& m_looks;
  const bool m_hasRegion;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
