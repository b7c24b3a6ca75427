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

#include <bit>

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
    HWY_ALIGN float opacities[most], reds[most] = {}, greens[most] = {}, blues[most] = {};
    // Of what the gradient does not change the share is known at once.
    hn::Store(m_changesOpacity ? absorbed.opacity : alphaOf(absorbed.extinction), floats, opacities);
    if (m_isPreintegrated || !m_hasGradient) {
      hn::Store(absorbed.color.x, floats, reds);
      hn::Store(absorbed.color.y, floats, greens);
      hn::Store(absorbed.color.z, floats, blues);
    }
    for (std::uint32_t bits = bitsOf(absorbed.seen); bits != 0 && !m_sum.hasEnded; bits &= bits - 1) {
      const int lane = std::countr_zero(bits);
      m_steps[m_queued] = static_cast<float>(i + lane);
      m_opacities[m_queued] = m_changesOpacity ? opacities[lane] : taken(opacities[lane]);
      if (m_isPreintegrated || !m_hasGradient) {
        m_reds[m_queued] = reds[lane];
        m_greens[m_queued] = greens[lane];
        m_blues[m_queued] = blues[lane];
      }
      if (++m_queued == lanes())
        light();
    }
  }

  HWY_INLINE VF alphaOf(VF extinction) const { return oneMinusExpNeg(hn::Mul(extinction, all(m_ray.units))); }

  // The share of the pixel that a sample of an opacity takes.
  HWY_INLINE float taken(float alpha) {
    const double share = m_sum.transmittance * alpha;
    m_sum.transmittance -= share;
    m_sum.hasEnded = m_sum.transmittance <= m_terms.lastTransmittance;
    return static_cast<float>(share);
  }

  // Lights what is queued and adds it.
  HWY_NOINLINE void light() {
    if (m_queued == 0)
      return;
    const VF step = hn::Load(floats, m_steps);
    V3 color{hn::Load(floats, m_reds), hn::Load(floats, m_greens), hn::Load(floats, m_blues)};
    Gradients gradients{zero(), hn::Zero(floats), hn::Zero(floats)};
    if (m_hasGradient) {
      const VoxelAndSlope found = m_samples.field.voxelAndSlopeAt(m_samples.indexAt(step), m_queued);
      if (!m_isPreintegrated)
        color = m_samples.function
                    .at(m_samples.field.normalised(found.voxel),
                        hn::FirstN(floats, static_cast<std::size_t>(m_queued)))
                    .color;
      gradients = m_samples.light.gradientsOf(found.slope);
    }
    if (m_changesOpacity)
      changeOpacities(gradients);
    for (int lane = m_queued; lane < most; ++lane)
      m_opacities[lane] = 0.0f;
    const VF shares = hn::Load(floats, m_opacities);
    const V3 lit = m_samples.light.shaded(color, gradients, step);
    m_sum.color = {hn::MulAdd(shares, lit.x, m_sum.color.x), hn::MulAdd(shares, lit.y, m_sum.color.y),
                   hn::MulAdd(shares, lit.z, m_sum.color.z)};
    m_queued = 0;
  }

  // Makes shares of the pixel of queued opacities that the gradient changes.
  HWY_INLINE void changeOpacities(const Gradients& gradients) {
    const VF opacity = hn::Mul(hn::Load(floats, m_opacities), m_samples.light.opacityFactor(gradients));
    HWY_ALIGN float alphas[most] = {};
    hn::Store(alphaOf(minusLog1mOpacity(opacity)), floats, alphas);
    for (int lane = 0; lane < m_queued; ++lane)
      m_opacities[lane] = m_sum.hasEnded ? 0.0f : taken(alphas[lane]);
  }

  const PictureTerms& m_terms;
  const Samples<kind>& m_samples;
  const Ray& m_ray;
  const bool m_isPreintegrated;
  const bool m_changesOpacity;
  const bool m_hasGradient;
  Sum m_sum;
  int m_queued = 0;
  HWY_ALIGN float m_steps[most] = {};
  HWY_ALIGN float m_opacities[most] = {}; // or already shares
  HWY_ALIGN float m_reds[most] = {}, m_greens[most] = {}, m_blues[most] = {};
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
