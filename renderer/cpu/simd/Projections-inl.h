// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the samples of a ray (DEFINITION section 7). As many as the registers hold are computed
// together; no sample depends on the others, so stepping over what is empty changes no bit.
#if defined(LIMN_CPU_PROJECTIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_PROJECTIONS_INL_H
#undef LIMN_CPU_PROJECTIONS_INL_H
#else
#define LIMN_CPU_PROJECTIONS_INL_H
#endif

#include "cpu/simd/BlocksAlike-inl.h"
#include "cpu/simd/CellMarch-inl.h"
#include "cpu/simd/CellScalars-inl.h"
#include "cpu/simd/Composite-inl.h"
#include "cpu/simd/Rays-inl.h"
#include "cpu/simd/SampledMarch-inl.h"
#include "cpu/simd/Samples-inl.h"

#include <bit>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// The pixel of what Marcher::scalars() gave for all of a ray.
inline glm::vec4 classifiedOnce(const PictureTerms& terms, const glm::dvec2& found) {
  if (found.y == 0.0)
    return glm::vec4(0.0f);
  const Function function(*terms.function, terms.segments);
  const double scalar = terms.effects.has(Effect::average) ? found.x / found.y
                        : terms.effects.has(Effect::mip)   ? found.x
                                                           : -found.x;
  const VF scalars = all(static_cast<float>(scalar));
  const Mask wanted = hn::FirstN(floats, 1);
  const V3 color = function.colorAt(scalars, wanted);
  const float opacity = hn::GetLane(function.opacityAt(scalars, wanted));
  return {opacity * hn::GetLane(color.x), opacity * hn::GetLane(color.y), opacity * hn::GetLane(color.z),
          opacity};
}

/// One ray of the picture that the terms describe, whatever its projection.
template <VoxelSource::Kind kind>
class Marcher {
public:
  Marcher(const PictureTerms& terms, const Ray& ray) : m_terms(terms), m_ray(ray), m_samples(terms, ray) {}

  glm::vec4 pixel() const {
    const EffectSet& effects = m_terms.effects;
    if (effects.hasAny(scalarProjections))
      return classifiedOnce(m_terms, scalars());
    if (effects.has(Effect::isosurface))
      return surface();
    if (effects.has(Effect::hybrid))
      return gatheredOverSurface();
    return gathered();
  }

  /// What the brick's part of the ray adds to the pixel, where other bricks may have the surface in front:
  /// its own and the nearest hit, +∞ where there is none.
  glm::vec4 share(float own, float nearest) const {
    const bool isHybrid = m_terms.effects.has(Effect::hybrid);
    if (!std::isfinite(nearest))
      return m_terms.effects.has(Effect::isosurface) ? glm::vec4(0.0f) : gathered();
    const glm::vec4 front = isHybrid ? gatheredBefore(nearest) : glm::vec4(0.0f);
    return own == nearest ? over(front, m_samples.surfaceAt(own)) : front;
  }

  /// +∞ where the ray meets no surface in the brick.
  float hit() const { return firstHit().value_or(std::numeric_limits<float>::infinity()); }

  /// The largest, smallest or all scalars that are kept: {the largest, {minus the smallest or {their sum,
  /// then how many; exactly, their integral and the length of what is kept.
  glm::dvec2 scalars() const {
    if (m_terms.isExact) {
      const Ray part = ownPart();
      if (!part.span.isEmpty())
        return CellScalars<kind>(m_terms, part, 0.0).scalars();
      return {m_terms.effects.has(Effect::average) ? 0.0 : -std::numeric_limits<double>::infinity(), 0.0};
    }
    const EffectSet& effects = m_terms.effects;
    const bool isLargest = effects.has(Effect::mip);
    VF extreme = all(isLargest ? -beyondScalars : beyondScalars);
    double total = 0.0;
    int kept = 0;
    for (int i = m_ray.ownFrom; i < m_ray.ownTo; i += lanes()) {
      const VF step = samplesFrom(i);
      const VF scalar = m_samples.scalarAt(step);
      const Mask isInside = m_samples.kept(step, isBefore(step, m_ray.ownTo));
      kept += static_cast<int>(hn::CountTrue(floats, isInside));
      if (effects.has(Effect::average))
        total += hn::GetLane(hn::SumOfLanes(floats, hn::IfThenElseZero(isInside, scalar)));
      else if (isLargest)
        extreme = hn::Max(extreme, hn::IfThenElse(isInside, scalar, extreme));
      else
        extreme = hn::Min(extreme, hn::IfThenElse(isInside, scalar, extreme));
    }
    if (effects.has(Effect::average))
      return {total, kept};
    if (kept == 0)
      return {-std::numeric_limits<double>::infinity(), 0.0};
    return {isLargest ? hn::GetLane(hn::MaxOfLanes(floats, extreme))
                      : -hn::GetLane(hn::MinOfLanes(floats, extreme)),
            1.0};
  }

private:
  HWY_INLINE VF samplesFrom(int i) const { return hn::Iota(floats, static_cast<float>(i)); }
  HWY_INLINE Mask isBefore(VF step, int end) const { return hn::Lt(step, all(static_cast<float>(end))); }

  // The integral along the ray.
  glm::vec4 gathered() const {
    // Cells may show between the last sample and the exit.
    if (m_terms.samplesFirst && m_ray.from < m_ray.to)
      return SampledMarch<kind>(m_terms, m_samples).gathered();
    if (m_terms.fineness)
      return gatheredCellByCell();
    if (m_terms.effects.has(Effect::xray))
      return xray();
    NoLog none;
    return Composite<kind>(m_terms, m_samples, none).gathered();
  }

  glm::vec4 gatheredCellByCell() const {
    const Ray part = ownPart();
    if (part.span.isEmpty())
      return glm::vec4(0.0f);
    // Nothing shows before the first of the ray's equal steps that may show, unless it is a part of one.
    const double from = m_terms.brick ? 0.0 : beforeSeen(m_terms, m_ray);
    return CellMarch<kind>(m_terms, part, from).gathered();
  }

  // The ray as far as it lies in the brick.
  Ray ownPart() const {
    Ray part = m_ray;
    if (m_terms.brick)
      part.span =
          partInBrick(m_terms, framedRay(m_terms.frame, part.pixel.x, part.pixel.y, m_terms.size), part.span);
    return part;
  }

  // One by one, so that the sum does not depend on which samples are computed together.
  HWY_INLINE static void addDepth(Mask seen, VF extinction, double& depth) {
    HWY_ALIGN float extinctions[HWY_MAX_BYTES / 4];
    hn::Store(extinction, floats, extinctions);
    for (std::uint32_t bits = bitsOf(seen); bits != 0; bits &= bits - 1)
      depth += extinctions[std::countr_zero(bits)];
  }

  glm::vec4 xray() const {
    const StepsAlike empty(m_terms.empty, m_ray, m_terms.effects.has(Effect::preintegration));
    double depth = 0.0;
    for (int i = m_ray.from; i < m_ray.to;) {
      if (const int leap = empty.samplesFrom(i); leap > 0) {
        i += leap;
        continue;
      }
      const VF step = samplesFrom(i);
      i += lanes();
      const auto shaded = m_samples.at(step, isBefore(step, m_ray.ownTo));
      if (!hn::AllFalse(floats, shaded.seen))
        addDepth(shaded.seen, shaded.extinction, depth);
    }
    return glm::vec4(static_cast<float>(-std::expm1(-depth * m_ray.units)));
  }

  HWY_INLINE Mask isHit(VF step) const {
    return m_samples.kept(step, hn::Ge(m_samples.scalarAt(step), all(m_terms.isovalue)));
  }

  // Where the field first reaches the isovalue in what is kept, in steps behind sample 0; absent where it
  // stays below.
  std::optional<float> firstHit() const { return m_terms.isExact ? firstHitInCells() : firstHitInSteps(); }

  std::optional<float> firstHitInCells() const {
    const Ray part = ownPart();
    if (part.span.isEmpty())
      return std::nullopt;
    const double seen = m_terms.brick ? 0.0 : beforeSeen(m_terms, m_ray);
    const std::optional<double> hit = CellScalars<kind>(m_terms, part, seen).firstHit();
    if (!hit)
      return std::nullopt;
    const double mm = part.span.begin + *hit * m_terms.lengthMm - m_ray.span.begin;
    return static_cast<float>(mm * m_ray.count / (m_ray.span.end - m_ray.span.begin) - m_ray.offset);
  }

  std::optional<float> firstHitInSteps() const {
    const float offset = m_ray.offset;
    const float exit = static_cast<float>(m_ray.count) - offset;
    // The entry counts as before the first sample, the exit as the last: whose samples they are has them.
    if (m_ray.ownFrom == m_ray.ownTo)
      return std::nullopt;
    if (m_ray.ownFrom == 0 && (bitsOf(isHit(all(-offset))) & 1u) != 0)
      return -offset;
    const StepsAlike empty(m_terms.empty, m_ray, false);
    const int last = m_ray.ownTo < m_ray.count ? m_ray.ownTo - 1 : m_ray.count;
    for (int i = m_ray.from; i <= last;) {
      if (const int leap = empty.samplesFrom(i); leap > 0 && i + leap <= last) {
        i += leap;
        continue;
      }
      const VF step = hn::Min(samplesFrom(i), all(exit));
      const auto lane = hn::FindFirstTrue(floats, isHit(step));
      if (lane >= 0) {
        const int sample = i + static_cast<int>(lane);
        if (sample > last && last < m_ray.count)
          return std::nullopt;
        const float above = std::min(static_cast<float>(sample), exit);
        return halved(sample == 0 ? -offset : std::min(static_cast<float>(sample - 1), exit), above);
      }
      i += lanes();
    }
    return std::nullopt;
  }

  // Halves a bracket until it is shorter than 1e-4 of a step. All middles that the next halvings may ask for
  // are looked at together: a tree of them, node k above nodes 2k and 2k+1.
  float halved(float below, float above) const {
    int levels = 0;
    while ((2 << levels) - 1 <= lanes())
      ++levels;
    HWY_ALIGN float low[HWY_MAX_BYTES / 4 + 1], high[HWY_MAX_BYTES / 4 + 1];
    HWY_ALIGN float middles[HWY_MAX_BYTES / 4] = {};
    for (int done = 0; done < halvings; done += levels) {
      low[1] = below;
      high[1] = above;
      const int nodes = (1 << levels) - 1;
      for (int node = 1; node <= nodes; ++node) {
        middles[node - 1] = 0.5f * (low[node] + high[node]);
        if (2 * node + 1 > nodes)
          continue;
        low[2 * node] = low[node];
        high[2 * node] = middles[node - 1];
        low[2 * node + 1] = middles[node - 1];
        high[2 * node + 1] = high[node];
      }
      const std::uint32_t bits = bitsOf(isHit(hn::Load(floats, middles)));
      for (int level = 0, node = 1; level < levels && done + level < halvings; ++level) {
        const bool isAbove = (bits >> (node - 1) & 1u) != 0;
        (isAbove ? above : below) = middles[node - 1];
        node = 2 * node + (isAbove ? 0 : 1);
      }
    }
    return above;
  }

  glm::vec4 surface() const {
    const std::optional<float> hit = firstHit();
    return hit ? glm::vec4(m_samples.surfaceAt(*hit), 1.0f) : glm::vec4(0.0f);
  }

  // Gathers what lies before the surface in steps of its own.
  glm::vec4 gatheredBefore(float hit) const {
    const double steps = double(hit) + m_ray.offset;
    const double end = m_ray.span.begin + steps * (m_ray.span.end - m_ray.span.begin) / m_ray.count;
    const Rays rays(m_terms, m_ray.pixel.x, m_ray.pixel.x + 1, m_ray.pixel.y, end);
    if (!rays.isSeen(0))
      return glm::vec4(0.0f);
    const Ray before = rays.ray(0);
    return Marcher(m_terms, before).gathered();
  }

  static glm::vec4 over(const glm::vec4& front, const glm::vec3& surface) {
    return {glm::vec3(front) + (1.0f - front.a) * surface, 1.0f};
  }

  glm::vec4 gatheredOverSurface() const {
    const std::optional<float> hit = firstHit();
    return hit ? over(gatheredBefore(*hit), m_samples.surfaceAt(*hit)) : gathered();
  }

  static constexpr int halvings = 14;
  static constexpr float beyondScalars = 3e38f;

  const PictureTerms& m_terms;
  const Ray& m_ray;
  Samples<kind> m_samples;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
