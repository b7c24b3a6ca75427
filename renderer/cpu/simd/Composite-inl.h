// SPDX-License-Identifier: GPL-3.0-or-later
// The integral along a ray in equal steps. First it is found, several samples at a time, what of them shows;
// what does is queued, and lit when there is enough to fill the registers: most samples of most rays show
// nothing.
#if defined(LIMN_CPU_COMPOSITE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_COMPOSITE_INL_H
#undef LIMN_CPU_COMPOSITE_INL_H
#else
#define LIMN_CPU_COMPOSITE_INL_H
#endif

#include "cpu/simd/BlocksAlike-inl.h"
#include "cpu/simd/SampleLog-inl.h"
#include "cpu/simd/Samples-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// The samples of one ray put together to a pixel, front to back (DEFINITION section 7). A log may be told of
/// each that shows (SampleLog-inl.h).
template <VoxelSource::Kind kind, class Log = NoLog>
class Composite {
public:
  Composite(const PictureTerms& terms, const Samples<kind>& samples, Log& log)
      : m_terms(terms), m_samples(samples), m_ray(samples.ray), m_log(log),
        m_isPreintegrated(terms.effects.has(Effect::preintegration)),
        m_changesOpacity(terms.effects.hasAny(opacityChanges)),
        m_hasGradient(terms.effects.has(Effect::gradient)),
        m_mixesLate(samples.looks.areAny() && m_changesOpacity),
        m_queuesColors(m_isPreintegrated || !m_hasGradient || (samples.looks.areAny() && !m_changesOpacity)),
        m_queuesUnits(m_isPreintegrated && m_mixesLate), m_isPart(terms.effects.has(Effect::region)),
        m_whole(terms, m_ray) {}

  glm::vec4 gathered() {
    const StepsAlike empty(m_terms.empty, m_ray, m_isPreintegrated);
    m_sum = {zero(), 1.0, false};
    m_turn = {};
    const bool canLightGroups = m_hasGradient && !m_isPreintegrated;
    bool isDense = false;
    int i = m_ray.from;
    lookAt(i - 1, false);
    while (i < m_ray.to && !m_sum.hasEnded) {
      if (const int leap = empty.samplesFrom(i); leap > 0) {
        lookAtEnds(i, leap);
        i += leap;
        isDense = false;
        continue;
      }
      // Where nearly all of a group showed, so will the next: it is not worth the look.
      const int seen = isDense ? lightGroup(i) : look(i);
      isDense = canLightGroups && 4 * seen >= 3 * lanes();
      i += lanes();
    }
    // Groups run over the last sample.
    if (i >= m_ray.count)
      lookAt(m_ray.count - 1, false);
    lookAt(std::min(i, m_ray.count), true);
    light();
    return pixelOf(m_sum, m_terms.effects);
  }

  /// What was gathered; a ray that has ended has left samples out.
  const Sum& sum() const { return m_sum; }

private:
  static constexpr int most = HWY_MAX_BYTES / 4;

  HWY_INLINE void lookBetween(int i, VF scalar, Mask isInside) {
    m_log.lookBetween(i, scalar, isInside, [this](int sample) {
      return m_isPart ? hn::GetLane(m_samples.weightAt(all(static_cast<float>(sample)))) : 1.0f;
    });
  }

  // Tells the log what lies beside the samples that may show, at sample `i` or at the entry or exit behind
  // which there is none; or only that the next follow it.
  HWY_INLINE void lookAt(int i, bool isNext) {
    if constexpr (Log::isKept) {
      const float place = i < 0              ? -m_ray.offset
                          : i >= m_ray.count ? static_cast<float>(m_ray.count) - m_ray.offset
                                             : static_cast<float>(i);
      lookBetween(i, m_samples.scalarAt(all(place)), hn::FirstN(floats, isNext ? 1 : 0));
    }
  }

  // The same of the first of some samples that show nothing and of the last, which the next follow.
  HWY_INLINE void lookAtEnds(int i, int count) {
    if constexpr (Log::isKept) {
      const Mask isFirst = hn::FirstN(floats, 1);
      const int last = std::min(i + count, m_ray.ownTo) - 1;
      lookBetween(i,
                  m_samples.scalarAt(
                      hn::IfThenElse(isFirst, all(static_cast<float>(i)), all(static_cast<float>(last)))),
                  isFirst);
    }
  }

  // Whether a region is known to keep all of the group of samples from `i` on.
  HWY_INLINE bool areWhole(int i) {
    return m_isPart && m_whole.isWhole(static_cast<float>(i), static_cast<float>(i + lanes() - 1));
  }

  // Looks at the group of samples from `i` on and queues what shows. Returns how many do.
  HWY_NOINLINE int look(int i) {
    const VF step = hn::Iota(floats, static_cast<float>(i));
    const Mask isInside = hn::Lt(step, all(static_cast<float>(m_ray.ownTo)));
    VF perUnit = hn::Zero(floats);
    const VF scalar = m_isPreintegrated ? hn::Zero(floats) : m_samples.scalarAt(step);
    const auto absorbed = m_isPreintegrated
                              ? m_samples.absorbedOver(step, isInside, areWhole(i), perUnit)
                              : m_samples.absorbedBy(scalar, step, isInside, areWhole(i), m_queuesColors);
    lookBetween(i, scalar, isInside);
    if (hn::AllFalse(floats, absorbed.seen))
      return 0;
    const int seen = static_cast<int>(hn::CountTrue(floats, absorbed.seen));
    // Of what the gradient does not change the share is known at once.
    const VF opacities =
        packed(m_changesOpacity ? absorbed.opacity : alphaOf(absorbed.extinction), absorbed.seen);
    hn::StoreU(m_changesOpacity ? opacities : taken(opacities), floats, m_opacities + m_queued);
    if constexpr (Log::isKept)
      hn::StoreU(opacities, floats, m_alphas + m_queued);
    hn::StoreU(packed(step, absorbed.seen), floats, m_steps + m_queued);
    if (m_queuesColors) {
      hn::StoreU(packed(absorbed.color.x, absorbed.seen), floats, m_reds + m_queued);
      hn::StoreU(packed(absorbed.color.y, absorbed.seen), floats, m_greens + m_queued);
      hn::StoreU(packed(absorbed.color.z, absorbed.seen), floats, m_blues + m_queued);
    }
    if (m_queuesUnits)
      hn::StoreU(packed(perUnit, absorbed.seen), floats, m_units + m_queued);
    m_queued += seen;
    if (m_queued < lanes())
      return seen;
    const int rest = m_queued - lanes();
    m_queued = lanes();
    light();
    keepBehind(m_steps);
    keepBehind(m_opacities);
    if constexpr (Log::isKept)
      keepBehind(m_alphas);
    if (m_queuesColors) {
      keepBehind(m_reds);
      keepBehind(m_greens);
      keepBehind(m_blues);
    }
    if (m_queuesUnits)
      keepBehind(m_units);
    m_queued = rest;
    return seen;
  }

  // Lights the group of samples from `i` on as it is. Returns how many of them show.
  HWY_NOINLINE int lightGroup(int i) {
    light();
    const VF step = hn::Iota(floats, static_cast<float>(i));
    const Mask isInside = hn::Lt(step, all(static_cast<float>(m_ray.ownTo)));
    const VoxelAndSlope found = voxelAndSlopeAt(m_terms, m_samples.field, m_samples.indexAt(step),
                                                std::min(lanes(), m_ray.ownTo - i));
    const VF scalar = m_samples.field.normalised(found.voxel);
    lookBetween(i, scalar, isInside);
    if (m_samples.looks.areAny()) {
      const Gradients gradients = m_samples.light.gradientsOf(found.slope);
      const Looks::Mixed mixed = mixedAt(step, scalar, gradients, isInside);
      return lightSeen(mixed.seen, alphaOf(mixed.extinction), mixed.color, gradients, step);
    }
    VF opacity;
    const Mask opaque = m_samples.function.opacityWhereSeen(scalar, isInside, opacity);
    const Mask seen = m_samples.weighed(step, opaque, areWhole(i), opacity);
    if (hn::AllFalse(floats, seen))
      return 0;
    const Gradients gradients = m_samples.light.gradientsOf(found.slope);
    const VF alpha = m_changesOpacity ? changed(opacity, gradients) : alphaOf(minusLog1mOpacity(opacity));
    return lightSeen(seen, alpha, m_samples.function.colorAt(scalar, seen), gradients, step);
  }

  // What looks make of samples whose gradients are known.
  HWY_INLINE Looks::Mixed mixedAt(VF step, VF scalar, const Gradients& gradients, Mask wanted) const {
    const VF factor = m_changesOpacity ? m_samples.light.opacityFactor(gradients) : all(1.0f);
    return m_samples.looks.mixedAt(m_samples.indexAt(step), scalar, factor, wanted, Looks::Colors::ofSeen);
  }

  // Lights and adds the seen samples of a group. Returns how many they are.
  HWY_INLINE int lightSeen(Mask seen, VF alpha, const V3& material, const Gradients& gradients, VF step) {
    const int count = static_cast<int>(hn::CountTrue(floats, seen));
    if (count == 0)
      return 0;
    const VF alphas = packed(alpha, seen);
    const VF shares = taken(alphas);
    // Paths of light go by the order of samples.
    const VF inPlace = count < lanes() ? unpacked(shares, seen) : shares;
    V3 lit = m_samples.shaded(material, gradients, step, inPlace, m_turn);
    if (count < lanes())
      lit = {packed(lit.x, seen), packed(lit.y, seen), packed(lit.z, seen)};
    m_log.add(packed(step, seen), alphas, shares, lit, count);
    add(shares, lit, count);
    return count;
  }

  // Adds the next `count` samples, each to the lane of its turn: sums do not depend on which samples were
  // computed together.
  HWY_INLINE void add(VF shares, V3 lit, int count) {
    if (m_lane != 0) {
      const VI turned = hn::And(hn::Iota(ints, lanes() - m_lane), hn::Set(ints, lanes() - 1));
      const auto lanesThere = hn::IndicesFromVec(floats, turned);
      shares = hn::TableLookupLanes(shares, lanesThere);
      lit = {hn::TableLookupLanes(lit.x, lanesThere), hn::TableLookupLanes(lit.y, lanesThere),
             hn::TableLookupLanes(lit.z, lanesThere)};
    }
    m_sum.color = {hn::MulAdd(shares, lit.x, m_sum.color.x), hn::MulAdd(shares, lit.y, m_sum.color.y),
                   hn::MulAdd(shares, lit.z, m_sum.color.z)};
    m_lane = (m_lane + count) & (lanes() - 1);
  }

  // The wanted numbers side by side, then zeros. In registers and not straight into memory, which takes some
  // processors a hundred cycles.
  HWY_INLINE static VF packed(VF values, Mask wanted) {
    return hn::IfThenElseZero(hn::FirstN(floats, hn::CountTrue(floats, wanted)),
                              hn::Compress(values, wanted));
  }

  // The numbers side by side back where they are wanted, zeros elsewhere.
  HWY_INLINE static VF unpacked(VF values, Mask wanted) {
    HWY_ALIGN float from[most], to[most];
    hn::Store(values, floats, from);
    hn::Store(hn::IfThenElseZero(wanted, all(1.0f)), floats, to);
    int next = 0;
    for (int lane = 0; lane < lanes(); ++lane)
      if (to[lane] != 0.0f)
        to[lane] = from[next++];
    return hn::Load(floats, to);
  }

  // What was queued behind those that were lit.
  HWY_INLINE static void keepBehind(float* queue) {
    hn::Store(hn::LoadU(floats, queue + lanes()), floats, queue);
  }

  HWY_INLINE VF alphaOf(VF extinction) const { return oneMinusExpNeg(hn::Mul(extinction, all(m_ray.units))); }

  // The shares of the pixel that the next samples take, given what each takes of the light that reaches it;
  // 0 behind the one that leaves nothing.
  HWY_INLINE VF taken(VF alphas) {
    constexpr int count = hn::MaxLanes(floats);
    const hn::CappedTag<double, 1> one;
    HWY_ALIGN float alpha[count];
    HWY_ALIGN float share[count];
    hn::Store(alphas, floats, alpha);
    auto transmittance = hn::Set(one, m_sum.transmittance);
    // Unrolled, so that they stay in registers: loading as a vector what was just stored number by number
    // waits for all of it.
    HWY_UNROLL(8)
    for (int i = 0; i < count; ++i) {
      const auto taken = hn::Set(one, static_cast<double>(alpha[i]));
      share[i] = static_cast<float>(hn::GetLane(hn::Mul(taken, transmittance)));
      transmittance = hn::NegMulAdd(taken, transmittance, transmittance);
    }
    const double last = m_terms.lastTransmittance;
    if (HWY_LIKELY(hn::GetLane(transmittance) > last)) {
      m_sum.transmittance = hn::GetLane(transmittance);
      return hn::Load(floats, share);
    }
    // As above, but with the one that leaves nothing found.
    m_sum.hasEnded = true;
    transmittance = hn::Set(one, m_sum.transmittance);
    int end = 0;
    while (end < count && hn::GetLane(transmittance) > last) {
      const auto taken = hn::Set(one, static_cast<double>(alpha[end++]));
      transmittance = hn::NegMulAdd(taken, transmittance, transmittance);
    }
    m_sum.transmittance = hn::GetLane(transmittance);
    return hn::IfThenElseZero(hn::FirstN(floats, static_cast<std::size_t>(end)), hn::Load(floats, share));
  }

  // Lights what is queued and adds it.
  HWY_NOINLINE void light() {
    if (m_queued == 0)
      return;
    const Mask isQueued = hn::FirstN(floats, static_cast<std::size_t>(m_queued));
    const VF step = hn::Load(floats, m_steps);
    V3 color{hn::Load(floats, m_reds), hn::Load(floats, m_greens), hn::Load(floats, m_blues)};
    Gradients gradients{zero(), hn::Zero(floats), hn::Zero(floats)};
    if (m_hasGradient) {
      const VoxelAndSlope found =
          voxelAndSlopeAt(m_terms, m_samples.field, m_samples.indexAt(step), m_queued);
      if (!m_queuesColors && !m_mixesLate)
        color = m_samples.function.colorAt(m_samples.field.normalised(found.voxel), isQueued);
      gradients = m_samples.light.gradientsOf(found.slope);
    }
    VF shares = hn::IfThenElseZero(isQueued, hn::Load(floats, m_opacities));
    VF alphas = Log::isKept ? hn::IfThenElseZero(isQueued, hn::Load(floats, m_alphas)) : shares;
    if (m_changesOpacity) {
      alphas = hn::IfThenElseZero(isQueued, m_mixesLate ? mixedLate(step, gradients, shares, isQueued, color)
                                                        : changed(shares, gradients));
      shares = taken(alphas);
    }
    const V3 lit = m_samples.shaded(color, gradients, step, shares, m_turn);
    m_log.add(step, alphas, shares, lit, m_queued);
    add(shares, lit, m_queued);
    m_queued = 0;
  }

  // What looks take of the light, of steps within one look by their opacities; the others get their colours.
  HWY_NOINLINE VF mixedLate(VF step, const Gradients& gradients, VF opacities, Mask queued, V3& color) const {
    const VF units = m_queuesUnits ? hn::Load(floats, m_units) : hn::Zero(floats);
    const Mask isSampled = hn::And(queued, hn::Le(units, hn::Zero(floats)));
    VF alpha = hn::Zero(floats);
    if (m_queuesUnits) {
      const VF factor = m_samples.light.opacityFactor(gradients);
      alpha = alphaOf(hn::Mul(minusLog1mOpacity(hn::Mul(opacities, factor)), units));
    }
    if (hn::AllFalse(floats, isSampled))
      return alpha;
    const Looks::Mixed mixed = mixedAt(step, m_samples.scalarAt(step), gradients, isSampled);
    color = chosen(isSampled, mixed.color, color);
    return hn::IfThenElse(isSampled, alphaOf(mixed.extinction), alpha);
  }

  // What opacities that the gradient changes take of the light.
  HWY_INLINE VF changed(VF opacities, const Gradients& gradients) const {
    return alphaOf(minusLog1mOpacity(hn::Mul(opacities, m_samples.light.opacityFactor(gradients))));
  }

  const PictureTerms& m_terms;
  const Samples<kind>& m_samples;
  const Ray& m_ray;
  Log& m_log;
  const bool m_isPreintegrated;
  const bool m_changesOpacity;
  const bool m_hasGradient;
  const bool m_mixesLate;    // looks of labels are mixed once the gradient is known
  const bool m_queuesColors; // beside opacities
  const bool m_queuesUnits;  // of steps within one look
  const bool m_isPart;       // a region is kept
  WholeAlong m_whole;
  Sum m_sum;
  SpreadTurn m_turn;
  int m_queued = 0;
  int m_lane = 0; // of the sum, for the next sample
  // Room for a group behind those that are not lit yet, and for what compressing writes behind that.
  HWY_ALIGN float m_steps[3 * most] = {};
  HWY_ALIGN float m_opacities[3 * most] = {};                // or already shares
  HWY_ALIGN float m_alphas[Log::isKept ? 3 * most : 1] = {}; // or yet opacities
  HWY_ALIGN float m_reds[3 * most] = {}, m_greens[3 * most] = {}, m_blues[3 * most] = {};
  HWY_ALIGN float m_units[3 * most] = {}; // unit distances in a length, 0 where a sample stands for its step
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
