// SPDX-License-Identifier: GPL-3.0-or-later
// The integral along a ray to a tolerance, by equal steps first: what each sample adds tells how far its
// neighbourhood may be off, and only where that is too far is the ray integrated cell by cell
// (scene/steps/CellRule.h).
#if defined(LIMN_CPU_SAMPLED_MARCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_SAMPLED_MARCH_INL_H
#undef LIMN_CPU_SAMPLED_MARCH_INL_H
#else
#define LIMN_CPU_SAMPLED_MARCH_INL_H
#endif

#include "cpu/simd/CellMarch-inl.h"
#include "cpu/simd/Composite-inl.h"
#include "scene/steps/CellRule.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// A ray in equal steps of sampledStep(), or a part of it in finer ones.
template <VoxelSource::Kind kind>
class SampledMarch {
public:
  SampledMarch(const PictureTerms& terms, const Samples<kind>& samples, bool isPart = false)
      : m_terms(terms), m_samples(samples), m_ray(samples.ray), m_isPart(isPart),
        m_log(*terms.function, samples.function, samples.ray) {}

  glm::vec4 gathered() {
    Sum sum{zero(), 1.0, false};
    if (!addTo(sum))
      return CellMarch<kind>(m_terms, m_ray, beforeSeen(m_terms, m_ray)).gathered();
    return pixelOf(sum, m_terms.effects);
  }

  /// Adds what the ray shows to what lies before it; false, and the sum as it was, where the steps ended too
  /// early to tell.
  bool addTo(Sum& sum) {
    Composite<kind, SampleLog> composite(m_terms, m_samples, m_log);
    composite.gathered();
    if (m_log.count() == 0 && m_log.missed().empty())
      return true;
    m_log.close();
    m_limit = static_cast<float>(largestRayError(*m_terms.fineness) / sum.transmittance);
    const Sum& sampled = composite.sum();
    const float squares = findErrors(sampled);
    if (squares <= m_limit * m_limit) {
      add(sampled, sum);
      return true;
    }
    const Sum before = sum;
    refine(worthRefining(squares), sum);
    // What was left out because nothing seemed to reach it.
    if (!sampled.hasEnded || sum.hasEnded || sum.transmittance <= 2.0 * m_terms.lastTransmittance)
      return true;
    sum = before;
    return false;
  }

private:
  static constexpr int chunk = 8; // on every instruction set, so that all decide alike

  // How far the pixel may be off for each sample, and the sum of their squares. Steps are exact where
  // what absorbs, and the light that it adds to or takes from what lies behind, change evenly from sample to
  // sample: their second differences tell where not.
  HWY_NOINLINE float findErrors(const Sum& sum) const {
    V3 behind{all(hn::GetLane(hn::SumOfLanes(floats, sum.color.x))),
              all(hn::GetLane(hn::SumOfLanes(floats, sum.color.y))),
              all(hn::GetLane(hn::SumOfLanes(floats, sum.color.z)))};
    float left = 1.0f;
    VF squares = hn::Zero(floats);
    for (int n = 0; n < m_log.count(); n += chunk) {
      // The colour of what is seen from here on.
      const V3 seen = scaled(behind, all(1.0f / std::max(left, least)));
      V3 light = zero();
      VF taken = hn::Zero(floats);
      for (int part = n; part < n + chunk; part += lanes()) {
        const VF error = errorsOf(part, seen);
        hn::StoreU(error, floats, m_log.errors() + part);
        squares = hn::MulAdd(error, error, squares);
        const VF share = hn::LoadU(floats, m_log.shares() + part);
        const V3 lit = colorsAt(part);
        const Mask isThere = hn::Gt(share, hn::Zero(floats));
        taken = hn::Add(taken, share);
        light = {hn::Add(light.x, hn::IfThenElseZero(isThere, hn::Mul(share, lit.x))),
                 hn::Add(light.y, hn::IfThenElseZero(isThere, hn::Mul(share, lit.y))),
                 hn::Add(light.z, hn::IfThenElseZero(isThere, hn::Mul(share, lit.z)))};
      }
      left -= hn::GetLane(hn::SumOfLanes(floats, taken));
      behind = {hn::Sub(behind.x, hn::SumOfLanes(floats, light.x)),
                hn::Sub(behind.y, hn::SumOfLanes(floats, light.y)),
                hn::Sub(behind.z, hn::SumOfLanes(floats, light.z))};
    }
    float found = hn::GetLane(hn::SumOfLanes(floats, squares));
    for (const Missed& missed : m_log.missed())
      found += missed.most * missed.most;
    return found;
  }

  HWY_INLINE V3 colorsAt(int n) const {
    return {hn::LoadU(floats, m_log.colors(0) + n), hn::LoadU(floats, m_log.colors(1) + n),
            hn::LoadU(floats, m_log.colors(2) + n)};
  }

  HWY_INLINE VF errorsOf(int n, const V3& seen) const {
    const VF one = all(1.0f), none = hn::Zero(floats);
    const VF step = hn::LoadU(floats, m_log.steps() + n);
    const Mask follows = hn::Eq(hn::LoadU(floats, m_log.steps() + n - 1), hn::Sub(step, one));
    const Mask isReached = hn::Gt(hn::LoadU(floats, m_log.shares() + n + 1), none);
    const Mask leads =
        hn::And(isReached, hn::Eq(hn::LoadU(floats, m_log.steps() + n + 1), hn::Add(step, one)));
    const VF alpha = hn::LoadU(floats, m_log.alphas() + n);
    const VF before = hn::IfThenElseZero(follows, hn::LoadU(floats, m_log.alphas() + n - 1));
    const VF next = hn::IfThenElseZero(leads, hn::LoadU(floats, m_log.alphas() + n + 1));
    const VF share = hn::LoadU(floats, m_log.shares() + n);
    const Mask takes = hn::Gt(alpha, all(least));
    const VF reaching = hn::IfThenElseZero(takes, hn::Div(share, hn::IfThenElse(takes, alpha, one)));
    VF most = none;
    for (int i = 0; i < 3; ++i) {
      const VF color = i == 0 ? seen.x : i == 1 ? seen.y : seen.z;
      const VF own = hn::Mul(alpha, hn::Sub(hn::LoadU(floats, m_log.colors(i) + n), color));
      const VF a = hn::Mul(before, hn::Sub(hn::LoadU(floats, m_log.colors(i) + n - 1), color));
      const VF b = hn::Mul(next, hn::Sub(hn::LoadU(floats, m_log.colors(i) + n + 1), color));
      VF off = hn::Abs(
          hn::Sub(hn::Add(hn::IfThenElseZero(follows, a), hn::IfThenElseZero(leads, b)), hn::Add(own, own)));
      most = hn::Max(most, off);
    }
    // Behind the last sample there may be anything.
    return hn::IfThenElseZero(takes, hn::Mul(reaching, most));
  }

  // The error from which on samples are looked at again, so that the others together are within the limit.
  float worthRefining(float squares) const {
    const float enough = m_limit * m_limit;
    float from = worst * m_limit;
    for (int halvings = 0; halvings < 8; ++halvings) {
      float rest = squares;
      for (int n = 0; n < m_log.count(); ++n)
        if (m_log.errors()[n] > from)
          rest -= m_log.errors()[n] * m_log.errors()[n];
      for (const Missed& missed : m_log.missed())
        if (missed.most > from)
          rest -= missed.most * missed.most;
      if (rest <= enough)
        return from;
      from *= 0.5f;
    }
    return 0.0f;
  }

  // A part of the ray, in steps behind its entry, [from, to).
  struct Stretch {
    float from, to;
  };

  // What is to be integrated cell by cell, front to back.
  std::vector<Stretch> stretches(float worth) const {
    std::vector<Stretch> found;
    const auto add = [&](float step) {
      const Stretch here{step - beside, step + 1.0f + beside};
      if (!found.empty() && here.from <= found.back().to + joined)
        found.back().to = std::max(found.back().to, here.to);
      else
        found.push_back(here);
    };
    auto missed = m_log.missed().begin();
    const auto addMissed = [&](float before) {
      for (; missed != m_log.missed().end() && float(missed->sample) <= before; ++missed)
        if (missed->most > worth)
          add(float(missed->sample));
    };
    for (int n = 0; n < m_log.count(); ++n) {
      addMissed(m_log.steps()[n]);
      if (m_log.errors()[n] > worth)
        add(m_log.steps()[n]);
    }
    addMissed(endless);
    return found;
  }

  // The samples put together once more, some parts of the ray more closely.
  HWY_NOINLINE void refine(float worth, Sum& sum) const {
    double reached = 1.0; // of the sampled sum
    int n = 0;
    for (const Stretch& stretch : stretches(worth)) {
      addSamples(n, stretch.from, reached, sum);
      skipSamples(n, stretch.to, reached);
      if (!sum.hasEnded && (m_isPart || !addFiner(stretch, sum)))
        addCells(stretch, sum);
    }
    addSamples(n, endless, reached, sum);
  }

  // Adds what lies behind a sum to it.
  HWY_INLINE void add(const Sum& behind, Sum& sum) const {
    const VF reaching = all(static_cast<float>(sum.transmittance));
    sum.color = {hn::MulAdd(reaching, behind.color.x, sum.color.x),
                 hn::MulAdd(reaching, behind.color.y, sum.color.y),
                 hn::MulAdd(reaching, behind.color.z, sum.color.z)};
    sum.transmittance *= behind.transmittance;
    sum.hasEnded = behind.hasEnded || sum.transmittance <= m_terms.lastTransmittance;
  }

  // Adds the samples from `n` on that lie before a place.
  HWY_NOINLINE void addSamples(int& n, float before, double& reached, Sum& sum) const {
    if (sum.hasEnded || reached <= 0.0)
      return;
    const auto factor = static_cast<float>(sum.transmittance / reached);
    double taken = 0.0;
    while (n < m_log.count() && m_log.steps()[n] < before) {
      const Mask isHere = hn::And(hn::Lt(hn::LoadU(floats, m_log.steps() + n), all(before)),
                                  hn::FirstN(floats, static_cast<std::size_t>(m_log.count() - n)));
      const VF share = hn::IfThenElseZero(isHere, hn::LoadU(floats, m_log.shares() + n));
      const VF weight = hn::Mul(share, all(factor));
      const V3 lit = colorsAt(n);
      sum.color = {hn::MulAdd(weight, hn::IfThenElseZero(isHere, lit.x), sum.color.x),
                   hn::MulAdd(weight, hn::IfThenElseZero(isHere, lit.y), sum.color.y),
                   hn::MulAdd(weight, hn::IfThenElseZero(isHere, lit.z), sum.color.z)};
      taken += hn::GetLane(hn::SumOfLanes(floats, share));
      n += static_cast<int>(hn::CountTrue(floats, isHere));
    }
    sum.transmittance = std::max(0.0, sum.transmittance - factor * taken);
    reached -= taken;
    sum.hasEnded = sum.transmittance <= m_terms.lastTransmittance;
  }

  void skipSamples(int& n, float before, double& reached) const {
    for (; n < m_log.count() && m_log.steps()[n] < before; ++n)
      reached -= m_log.shares()[n];
  }

  // Adds a stretch in finer steps; false where cells are to be taken.
  HWY_NOINLINE bool addFiner(const Stretch& stretch, Sum& sum) const {
    const float from = std::max(stretch.from, 0.0f), to = std::min(stretch.to, float(m_ray.count));
    const int count = static_cast<int>((to - from) * float(finerSteps));
    if (count <= 0)
      return true;
    constexpr float part = 1.0f / float(finerSteps);
    const float shift = from + 0.5f * part - m_ray.offset;
    Ray ray = m_ray;
    ray.count = ray.to = ray.ownTo = count;
    ray.from = ray.ownFrom = 0;
    ray.offset = 0.5f;
    ray.first += shift * m_ray.stride;
    ray.firstIndex += shift * m_ray.stride;
    ray.stride *= part;
    ray.firstDepth += shift * m_ray.strideDepth;
    ray.strideDepth *= part;
    ray.units *= part;
    ray.span = spanOf(stretch);
    return SampledMarch(m_terms, Samples<kind>(m_terms, ray), true).addTo(sum);
  }

  RaySpan spanOf(const Stretch& stretch) const {
    const double stepMm = (m_ray.span.end - m_ray.span.begin) / m_ray.count;
    const double count = m_ray.count;
    return {m_ray.span.begin + std::clamp(double(stretch.from), 0.0, count) * stepMm,
            m_ray.span.begin + std::clamp(double(stretch.to), 0.0, count) * stepMm};
  }

  HWY_NOINLINE void addCells(const Stretch& stretch, Sum& sum) const {
    Ray part = m_ray;
    part.span = spanOf(stretch);
    if (!part.span.isEmpty())
      CellMarch<kind>(m_terms, part, 0.0).addTo(sum);
  }

  static constexpr float least = 1e-5f;
  static constexpr float worst = 0.5f;  // share of the limit
  static constexpr float beside = 1.0f; // steps about a sample that is off
  static constexpr float joined = 2.0f; // steps between stretches that are one

  static constexpr int finerSteps = 8;
  static constexpr float endless = 3e38f;

  const PictureTerms& m_terms;
  const Samples<kind>& m_samples;
  const Ray& m_ray;
  const bool m_isPart;
  float m_limit = 0.0f;
  SampleLog m_log;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
