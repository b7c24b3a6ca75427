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
  SampledMarch(const PictureTerms& terms, const Samples<kind>& samples)
      : m_terms(terms), m_samples(samples), m_ray(samples.ray),
        m_log(*terms.function, samples.function, samples.ray, mostFactor(terms)) {}

  /// A part before what looks so.
  SampledMarch(const PictureTerms& terms, const Samples<kind>& samples, const glm::vec4& beyond)
      : SampledMarch(terms, samples) {
    m_isFiner = true;
    m_beyond = beyond;
  }

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
    m_log.close(composite.sum().hasEnded);
    m_limit = static_cast<float>(largestRayError(*m_terms.fineness) / sum.transmittance);
    const Sum& sampled = composite.sum();
    const float squares = findErrors(sampled);
    if (squares <= m_limit * m_limit) {
      add(sampled, sum);
      return true;
    }
    const Sum before = sum;
    refine(sampled, worthRefining(squares), sum);
    // What was left out because nothing seemed to reach it.
    if (!sampled.hasEnded || sum.hasEnded || sum.transmittance <= 2.0 * m_terms.lastTransmittance)
      return true;
    sum = before;
    return false;
  }

private:
  static constexpr int chunk = SampleLog::chunk;

  // The most that gradients make of an opacity, of the curve over them 1.
  static float mostFactor(const PictureTerms& terms) {
    const CoefficientRange& range = terms.light.opacity;
    return terms.effects.hasAny(opacityChanges)
               ? static_cast<float>(std::max({1.0, range.atFlat, range.atBoundary}))
               : 1.0f;
  }

  // Premultiplied colour and alpha.
  static glm::vec4 gatheredBy(const Sum& sum) {
    return {hn::GetLane(hn::SumOfLanes(floats, sum.color.x)),
            hn::GetLane(hn::SumOfLanes(floats, sum.color.y)),
            hn::GetLane(hn::SumOfLanes(floats, sum.color.z)), static_cast<float>(1.0 - sum.transmittance)};
  }

  // How far the pixel may be off for each sample, and the sum of their squares. Steps are exact where
  // what absorbs, and the light that it adds to or takes from what lies behind, change evenly from sample to
  // sample: their second differences tell where not.
  HWY_NOINLINE float findErrors(const Sum& sum) const {
    glm::vec4 behind = gatheredBy(sum) + static_cast<float>(sum.transmittance) * m_beyond;
    float left = 1.0f;
    VF squares = hn::Zero(floats);
    for (int n = 0; n < m_log.count(); n += chunk) {
      // What is seen from here on.
      const glm::vec4 seen = behind / std::max(left, least);
      for (int part = n; part < n + chunk; part += lanes()) {
        const VF error = errorsOf(part, seen);
        hn::StoreU(error, floats, m_log.errors() + part);
        squares = hn::MulAdd(error, error, squares);
        const glm::vec4 added = addedBy(part, hn::LoadU(floats, m_log.shares() + part));
        left -= added.a;
        behind -= added;
      }
    }
    float found = hn::GetLane(hn::SumOfLanes(floats, squares));
    for (const Missed& missed : m_log.missed())
      found += missed.most * missed.most;
    return found;
  }

  // What some samples add to the pixel, of which each takes a share.
  HWY_INLINE glm::vec4 addedBy(int n, VF share) const {
    const Mask isThere = hn::Gt(share, hn::Zero(floats));
    const V3 lit = colorsAt(n);
    const auto sumOf = [&](VF color) {
      return hn::GetLane(hn::SumOfLanes(floats, hn::IfThenElseZero(isThere, hn::Mul(share, color))));
    };
    return {sumOf(lit.x), sumOf(lit.y), sumOf(lit.z), hn::GetLane(hn::SumOfLanes(floats, share))};
  }

  HWY_INLINE V3 colorsAt(int n) const {
    return {hn::LoadU(floats, m_log.colors(0) + n), hn::LoadU(floats, m_log.colors(1) + n),
            hn::LoadU(floats, m_log.colors(2) + n)};
  }

  HWY_INLINE VF errorsOf(int n, const glm::vec4& seen) const {
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
    // Alpha is a colour of 1 everywhere.
    VF most =
        hn::Mul(all(std::abs(1.0f - seen.a)), hn::Abs(hn::Sub(hn::Add(before, next), hn::Add(alpha, alpha))));
    for (int i = 0; i < 3; ++i) {
      const VF color = all(seen[i]);
      const VF own = hn::Mul(alpha, hn::Sub(hn::LoadU(floats, m_log.colors(i) + n), color));
      const VF a = hn::Mul(before, hn::Sub(hn::LoadU(floats, m_log.colors(i) + n - 1), color));
      const VF b = hn::Mul(next, hn::Sub(hn::LoadU(floats, m_log.colors(i) + n + 1), color));
      const VF off = hn::Abs(
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

  // How far along the samples, what of the light comes there, and what they add from there on.
  struct Place {
    int n;
    double reached;
    glm::vec4 rest;
  };

  // The samples put together once more, some parts of the ray more closely.
  HWY_NOINLINE void refine(const Sum& sampled, float worth, Sum& sum) const {
    const glm::vec4 all = gatheredBy(sampled) + static_cast<float>(sampled.transmittance) * m_beyond;
    Place place{0, 1.0, all};
    for (const Stretch& stretch : stretches(worth)) {
      addSamples(place, stretch.from, sum);
      skipSamples(place, stretch.to);
      if (!sum.hasEnded && (m_isFiner || !addFiner(stretch, place, sum)))
        addCells(stretch, sum);
    }
    addSamples(place, endless, sum);
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

  // Adds the samples that lie before a place on the ray.
  HWY_NOINLINE void addSamples(Place& place, float before, Sum& sum) const {
    if (sum.hasEnded || place.reached <= 0.0)
      return;
    const auto factor = static_cast<float>(sum.transmittance / place.reached);
    double passed = 1.0;
    while (place.n < m_log.count() && m_log.steps()[place.n] < before) {
      const int n = place.n;
      const Mask isHere = hn::And(hn::Lt(hn::LoadU(floats, m_log.steps() + n), all(before)),
                                  hn::FirstN(floats, static_cast<std::size_t>(m_log.count() - n)));
      const VF share = hn::IfThenElseZero(isHere, hn::LoadU(floats, m_log.shares() + n));
      const VF weight = hn::Mul(share, all(factor));
      const V3 lit = colorsAt(n);
      sum.color = {hn::MulAdd(weight, hn::IfThenElseZero(isHere, lit.x), sum.color.x),
                   hn::MulAdd(weight, hn::IfThenElseZero(isHere, lit.y), sum.color.y),
                   hn::MulAdd(weight, hn::IfThenElseZero(isHere, lit.z), sum.color.z)};
      place.rest -= addedBy(n, share);
      place.n += static_cast<int>(hn::CountTrue(floats, isHere));
      passed *= passedFrom(n, place.n);
    }
    sum.transmittance *= passed;
    place.reached *= passed;
    sum.hasEnded = sum.transmittance <= m_terms.lastTransmittance;
  }

  // What samples `n` to before `end` leave of the light, but for those that none reaches.
  double passedFrom(int n, int end) const {
    double passed = 1.0;
    for (; n < end; ++n)
      if (m_log.shares()[n] > 0.0f)
        passed *= 1.0 - double(m_log.alphas()[n]);
    return passed;
  }

  void skipSamples(Place& place, float before) const {
    const int first = place.n;
    for (; place.n < m_log.count() && m_log.steps()[place.n] < before; ++place.n) {
      const float share = m_log.shares()[place.n];
      if (share > 0.0f)
        place.rest -= share * glm::vec4(m_log.colors(0)[place.n], m_log.colors(1)[place.n],
                                        m_log.colors(2)[place.n], 1.0f);
    }
    place.reached *= passedFrom(first, place.n);
  }

  // Adds a stretch in finer steps; false where cells are to be taken.
  HWY_NOINLINE bool addFiner(const Stretch& stretch, const Place& behind, Sum& sum) const {
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
    const Samples<kind> samples(m_terms, ray);
    const glm::vec4 beyond = behind.rest / std::max(static_cast<float>(behind.reached), least);
    return SampledMarch(m_terms, samples, glm::clamp(beyond, 0.0f, 1.0f)).addTo(sum);
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
  bool m_isFiner = false;   // no part is taken in finer steps
  glm::vec4 m_beyond{0.0f}; // what light that gets past the samples meets
  float m_limit = 0.0f;
  SampleLog m_log;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
