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

#include "cpu/simd/EmptySpace-inl.h"
#include "cpu/simd/Samples-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

template <VoxelSource::Kind kind>
class Composite {
public:
  Composite(const PictureTerms& terms, const Samples<kind>& samples)
      : m_terms(terms), m_samples(samples), m_ray(samples.ray),
        m_isPreintegrated(terms.effects.has(Effect::preintegration)),
        m_changesOpacity(
            terms.effects.hasAny({Effect::opacityMap, Effect::opacityFactor, Effect::gradientOpacity})),
        m_hasGradient(terms.effects.has(Effect::gradient)) {}

  glm::vec4 gathered() {
    const EmptySteps empty(m_terms.empty, m_ray, m_isPreintegrated);
    m_sum = {zero(), 1.0, false};
    for (int i = m_ray.from; i < m_ray.to && !m_sum.hasEnded;) {
      if (const int leap = empty.samplesFrom(i); leap > 0) {
        i += leap;
        continue;
      }
      look(i);
      i += lanes();
    }
    light();
    return pixelOf(m_sum, m_terms.effects);
  }

private:
  static constexpr int most = HWY_MAX_BYTES / 4;

  // Looks at the group of samples from `i` on.
  HWY_NOINLINE void look(int i) {
    const VF step = hn::Iota(floats, static_cast<float>(i));
    const Mask isInside = hn::Lt(step, all(static_cast<float>(m_ray.count)));
    const auto absorbed = m_isPreintegrated
                              ? m_samples.absorbedOver(step, isInside)
                              : m_samples.absorbedBy(m_samples.scalarAt(step), isInside, !m_hasGradient);
    if (hn::AllFalse(floats, absorbed.seen))
      return;
    // Of what the gradient does not change the share is known at once.
    const VF opacities = m_changesOpacity ? absorbed.opacity : alphaOf(absorbed.extinction);
    queue(step, absorbed.seen, m_steps);
    queue(opacities, absorbed.seen, m_opacities);
    if (m_isPreintegrated || !m_hasGradient) {
      queue(absorbed.color.x, absorbed.seen, m_reds);
      queue(absorbed.color.y, absorbed.seen, m_greens);
      queue(absorbed.color.z, absorbed.seen, m_blues);
    }
    const int seen = static_cast<int>(hn::CountTrue(floats, absorbed.seen));
    const int last = m_queued + seen;
    if (m_changesOpacity) {
      m_queued = last;
    } else {
      m_queued = take(m_queued, last);
    }
    if (m_queued < lanes())
      return;
    const int rest = m_queued - lanes();
    m_queued = lanes();
    light();
    keepBehind(m_steps);
    keepBehind(m_opacities);
    if (m_isPreintegrated || !m_hasGradient) {
      keepBehind(m_reds);
      keepBehind(m_greens);
      keepBehind(m_blues);
    }
    m_queued = rest;
  }

  // In registers and not straight into memory, which takes some processors a hundred cycles.
  HWY_INLINE void queue(VF values, Mask wanted, float* end) {
    hn::StoreU(hn::Compress(values, wanted), floats, end + m_queued);
  }

  // What was queued behind those that were lit.
  HWY_INLINE static void keepBehind(float* queue) {
    hn::Store(hn::LoadU(floats, queue + lanes()), floats, queue);
  }

  HWY_INLINE VF alphaOf(VF extinction) const { return oneMinusExpNeg(hn::Mul(extinction, all(m_ray.units))); }

  // Makes shares of the pixel of queued opacities, until nothing is left of the light. Returns the end of
  // those that are something.
  HWY_INLINE int take(int from, int to) {
    double transmittance = m_sum.transmittance;
    const double last = m_terms.lastTransmittance;
    int i = from;
    while (i < to && !m_sum.hasEnded) {
      const double share = transmittance * m_opacities[i];
      m_opacities[i++] = static_cast<float>(share);
      transmittance -= share;
      m_sum.hasEnded = transmittance <= last;
    }
    m_sum.transmittance = transmittance;
    return i;
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
      const VoxelAndSlope found = m_samples.field.voxelAndSlopeAt(m_samples.indexAt(step), m_queued);
      if (!m_isPreintegrated)
        color = m_samples.function.colorAt(m_samples.field.normalised(found.voxel),
                                           isQueued);
      gradients = m_samples.light.gradientsOf(found.slope);
    }
    if (m_changesOpacity)
      changeOpacities(gradients);
    const VF shares = hn::IfThenElseZero(isQueued, hn::Load(floats, m_opacities));
    const V3 lit = m_samples.light.shaded(color, gradients, step);
    m_sum.color = {hn::MulAdd(shares, lit.x, m_sum.color.x), hn::MulAdd(shares, lit.y, m_sum.color.y),
                   hn::MulAdd(shares, lit.z, m_sum.color.z)};
    m_queued = 0;
  }

  // Makes shares of the pixel of queued opacities that the gradient changes.
  HWY_INLINE void changeOpacities(const Gradients& gradients) {
    const VF opacity = hn::Mul(hn::Load(floats, m_opacities), m_samples.light.opacityFactor(gradients));
    hn::Store(alphaOf(minusLog1mOpacity(opacity)), floats, m_opacities);
    const int end = take(0, m_queued);
    for (int lane = end; lane < m_queued; ++lane)
      m_opacities[lane] = 0.0f;
  }

  const PictureTerms& m_terms;
  const Samples<kind>& m_samples;
  const Ray& m_ray;
  const bool m_isPreintegrated;
  const bool m_changesOpacity;
  const bool m_hasGradient;
  Sum m_sum;
  int m_queued = 0;
  // Room for a group behind those that are not lit yet, and for what compressing writes behind that.
  HWY_ALIGN float m_steps[3 * most] = {};
  HWY_ALIGN float m_opacities[3 * most] = {}; // or already shares
  HWY_ALIGN float m_reds[3 * most] = {}, m_greens[3 * most] = {}, m_blues[3 * most] = {};
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
