// SPDX-License-Identifier: GPL-3.0-or-later
// What labels with looks of their own make of samples (DEFINITION section 10). A sample all of whose
// voxels have one look is classified by that look; only where looks meet are those of the eight voxels read.
#if defined(LIMN_CPU_LOOKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_LOOKS_INL_H
#undef LIMN_CPU_LOOKS_INL_H
#else
#define LIMN_CPU_LOOKS_INL_H
#endif

#include "cpu/rays/PictureTerms.h"
#include "cpu/simd/Field-inl.h"
#include "cpu/simd/Function-inl.h"
#include "scene/regions/BlockLooks.h"

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

  /// Of which samples colours are found: of all, those that absorb nothing have their only look's, or are
  /// black where looks meet.
  enum class Colors { ofNone, ofSeen, ofAll };

  /// What samples absorb.
  struct Mixed {
    Mask seen;     // where some look has an opacity, whatever the factor makes of it
    V3 color;      // as asked for
    VF extinction; // per length
  };

  /// Samples at continuous voxel indices with the scalars there, their opacities times `factor`.
  HWY_NOINLINE Mixed mixedAt(const V3& index, VF scalar, VF factor, Mask wanted, Colors colors) const {
    HWY_ALIGN float alone[most];
    const LookBits bits = looksOfCells(index, wanted, alone);
    const VF look = hn::Load(floats, alone);
    const Mask meets = hn::AndNot(hn::Ge(look, hn::Zero(floats)), wanted);
    if (hn::AllFalse(floats, meets) && std::has_single_bit(bits))
      return byOne(std::countr_zero(bits), index, scalar, factor, wanted, colors);
    return bySeveral(bits, look, meets, index, scalar, factor, wanted, colors);
  }

  /// Of pre-integrated steps those that lie within one look.
  struct Within {
    Mask steps; // they
    Mask seen;  // where something of the look's means shows
    V3 color;
    VF opacity;    // over the look's unit distance
    VF extinction; // likewise
    VF perUnit;    // of its unit distances in a length
  };

  /// Steps between continuous voxel indices, with the scalars there, and the indices of their midpoints.
  HWY_NOINLINE Within within(const V3& begin, const V3& middle, const V3& end, VF before, VF behind,
                             Mask wanted) const {
    HWY_ALIGN float first[most], mid[most], last[most];
    const LookBits bits = looksOfCells(begin, wanted, first) & looksOfCells(middle, wanted, mid) &
                          looksOfCells(end, wanted, last);
    const VF look = hn::Load(floats, first);
    const Mask isOne = hn::And(hn::Eq(look, hn::Load(floats, mid)), hn::Eq(look, hn::Load(floats, last)));
    Within result;
    result.steps = hn::And(wanted, hn::And(isOne, hn::Ge(look, hn::Zero(floats))));
    result.seen = none();
    result.color = zero();
    result.opacity = result.extinction = result.perUnit = hn::Zero(floats);
    for (LookBits left = bits; left != 0; left &= left - 1)
      addMeans(std::countr_zero(left), look, before, behind, result);
    if (m_hasRegion && !hn::AllFalse(floats, result.seen)) {
      const VF weight = weightAt(middle);
      result.opacity = hn::Mul(result.opacity, weight);
      result.extinction = minusLog1mOpacity(result.opacity);
      result.seen = hn::And(result.seen, hn::Gt(weight, hn::Zero(floats)));
    }
    return result;
  }

private:
  static constexpr int most = HWY_MAX_BYTES / 4;
  static constexpr int mostFunctions = static_cast<int>(mostLooks) + 1;

  HWY_INLINE static Mask none() { return hn::Lt(all(0.0f), hn::Zero(floats)); }

  // What one look makes of the steps that lie within it.
  HWY_INLINE void addMeans(int number, VF look, VF before, VF behind, Within& result) const {
    const Mask own = hn::And(result.steps, hn::Eq(look, all(static_cast<float>(number))));
    if (hn::AllFalse(floats, own))
      return;
    const Function function = functionOf(number);
    const Mask seen = hn::And(own, function.mayBeSeenBetween(before, behind));
    if (hn::AllFalse(floats, seen))
      return;
    const Mean mean = function.meanBetween(before, behind, seen);
    result.seen = hn::Or(result.seen, seen);
    result.color = chosen(seen, mean.color, result.color);
    result.extinction = hn::IfThenElse(seen, mean.extinction, result.extinction);
    result.opacity = hn::IfThenElse(seen, oneMinusExpNeg(mean.extinction), result.opacity);
    result.perUnit =
        hn::IfThenElse(seen, all(m_looks.all[static_cast<std::size_t>(number)].perUnit), result.perUnit);
  }

  // The looks of the cells of which each has one. `alone` says it for each sample, and -1 where looks meet.
  HWY_INLINE LookBits looksOfCells(const V3& index, Mask wanted, float alone[most]) const {
    const Cells cells = Field<VoxelSource::Kind::byte>(m_looks.voxels).cellsAt(index);
    // At the end of an axis another cell begins, of that voxel alone.
    const auto lowOf = [](VI low, VF weight) { return hn::Add(low, intOf(hn::Floor(weight))); };
    const VI y = lowOf(cells.y, cells.weight.y), z = lowOf(cells.z, cells.weight.z);
    HWY_ALIGN std::int32_t x[most], row[most];
    hn::Store(lowOf(cells.x, cells.weight.x), ints, x);
    hn::Store(hn::Add(hn::Mul(z, hn::Set(ints, m_looks.voxels.dims.y)), y), ints, row);
    const std::uint32_t lanesWanted = bitsOf(wanted);
    const std::int64_t length = m_looks.voxels.dims.x;
    LookBits any = 0;
    for (int lane = 0; lane < lanes(); ++lane) {
      alone[lane] = -1.0f;
      if ((lanesWanted >> lane & 1u) == 0)
        continue;
      const std::uint8_t own = m_looks.ofCells[row[lane] * length + x[lane]];
      if (own == severalLooks)
        continue;
      any |= LookBits{1} << own;
      alone[lane] = static_cast<float>(own);
    }
    return any;
  }

  // The looks of the voxels around some samples.
  HWY_INLINE static LookBits looksIn(const VF look[8], Mask wanted) {
    const std::uint32_t lanesWanted = bitsOf(wanted);
    LookBits any = 0;
    for (int corner = 0; corner < 8; ++corner) {
      HWY_ALIGN std::int32_t looks[most];
      hn::Store(hn::ConvertTo(ints, look[corner]), ints, looks);
      for (std::uint32_t left = lanesWanted; left != 0; left &= left - 1)
        any |= LookBits{1} << looks[std::countr_zero(left)];
    }
    return any;
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
                           Colors colors) const {
    const Function function = functionOf(look);
    Mixed mixed{wanted, zero(), hn::Zero(floats)};
    VF opacity;
    mixed.seen = function.opacityWhereSeen(scalar, wanted, opacity);
    if (m_hasRegion && !hn::AllFalse(floats, mixed.seen)) {
      const VF weight = weightAt(index);
      opacity = hn::Mul(opacity, weight);
      mixed.seen = hn::And(mixed.seen, hn::Gt(weight, hn::Zero(floats)));
    }
    if (colors == Colors::ofAll)
      mixed.color = function.colorAt(scalar, wanted);
    if (hn::AllFalse(floats, mixed.seen))
      return mixed;
    mixed.extinction = hn::IfThenElseZero(mixed.seen, extinctionOf(look, opacity, factor));
    if (colors == Colors::ofSeen)
      mixed.color = function.colorAt(scalar, mixed.seen);
    return mixed;
  }

  // The eight voxels around each sample: their looks, and the shares of the sample that they have.
  struct Around {
    VF look[8], share[8], weight[8];
  };

  HWY_INLINE void weighAround(const V3& index, Around& around) const {
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

  HWY_NOINLINE Mixed bySeveral(LookBits bits, VF alone, Mask meets, const V3& index, VF scalar, VF factor,
                               Mask wanted, Colors colors) const {
    Mixed mixed{none(), zero(), hn::Zero(floats)};
    const LookBits ofAlone = bits;
    const bool anyMeets = !hn::AllFalse(floats, meets);
    Around around;
    if (anyMeets) {
      const Field<VoxelSource::Kind::byte> looksAround(m_looks.voxels);
      looksAround.cornersAt(index, around.look, around.share);
      bits |= looksIn(around.look, meets);
    }
    int looks[mostFunctions];
    VF opacities[mostFunctions];
    Mask seen[mostFunctions];
    int count = 0;
    for (; bits != 0; bits &= bits - 1) {
      const int look = std::countr_zero(bits);
      const Mask mayHave = hn::And(wanted, hn::Or(meets, hn::Eq(alone, all(static_cast<float>(look)))));
      seen[count] = functionOf(look).opacityWhereSeen(scalar, mayHave, opacities[count]);
      if (hn::AllFalse(floats, seen[count]))
        continue;
      looks[count++] = look;
      mixed.seen = hn::Or(mixed.seen, seen[count - 1]);
    }
    if (count == 0) {
      if (colors == Colors::ofAll)
        colorUnseen(ofAlone, alone, scalar, wanted, mixed);
      return mixed;
    }
    const VF weightAlone = m_hasRegion ? weightAt(index) : all(1.0f);
    const bool mixes = anyMeets && !hn::AllFalse(floats, hn::And(meets, mixed.seen));
    if (mixes && m_hasRegion)
      weighAround(index, around);
    mixed.seen = none();
    VF extinctions[mostFunctions];
    for (int i = 0; i < count; ++i) {
      VF share = all(1.0f), weight = weightAlone;
      if (mixes) {
        VF met, weighed;
        shareOf(around, all(static_cast<float>(looks[i])), m_hasRegion, met, weighed);
        const VF safe = hn::IfThenElse(hn::Gt(met, hn::Zero(floats)), met, all(1.0f));
        share = hn::IfThenElse(meets, met, share);
        if (m_hasRegion)
          weight = hn::IfThenElse(meets, hn::Div(weighed, safe), weight);
      }
      seen[i] = hn::And(seen[i], hn::And(hn::Gt(share, hn::Zero(floats)), hn::Gt(weight, hn::Zero(floats))));
      const VF opacity = m_hasRegion ? hn::Mul(opacities[i], weight) : opacities[i];
      extinctions[i] = hn::IfThenElseZero(seen[i], hn::Mul(share, extinctionOf(looks[i], opacity, factor)));
      mixed.extinction = hn::Add(mixed.extinction, extinctions[i]);
      mixed.seen = hn::Or(mixed.seen, seen[i]);
    }
    if (colors == Colors::ofNone)
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
    if (colors == Colors::ofAll)
      colorUnseen(ofAlone, alone, scalar, wanted, mixed);
    return mixed;
  }

  // Between nodes colours are quadratics, so that one counts that absorbs nothing itself: it must not depend
  // on what the samples beside it show.
  HWY_INLINE void colorUnseen(LookBits bits, VF alone, VF scalar, Mask wanted, Mixed& mixed) const {
    const Mask unseen = hn::AndNot(hn::Gt(mixed.extinction, hn::Zero(floats)), wanted);
    for (; bits != 0; bits &= bits - 1) {
      const int look = std::countr_zero(bits);
      const Mask own = hn::And(unseen, hn::Eq(alone, all(static_cast<float>(look))));
      if (!hn::AllFalse(floats, own))
        mixed.color = chosen(own, functionOf(look).colorAt(scalar, own), mixed.color);
    }
  }

  const PictureTerms& m_terms;
  const LookTerms& m_looks;
  const bool m_hasRegion;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
