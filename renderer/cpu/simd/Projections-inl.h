// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the samples of a ray (DEFINITION section 7). As many as the registers hold are computed
// together, the first of them always a multiple of that number: so stepping over what is empty changes no
// bit.
#if defined(LIMN_CPU_PROJECTIONS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_PROJECTIONS_INL_H
#undef LIMN_CPU_PROJECTIONS_INL_H
#else
#define LIMN_CPU_PROJECTIONS_INL_H
#endif

#include "cpu/Ray.h"
#include "cpu/simd/EmptySpace-inl.h"
#include "cpu/simd/Field-inl.h"
#include "cpu/simd/Function-inl.h"
#include "cpu/simd/Light-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

template <VoxelSource::Kind kind>
class Marcher {
public:
  Marcher(const PictureTerms& terms, const Ray& ray)
      : m_terms(terms), m_field(terms.voxels), m_function(*terms.function), m_ray(ray) {}

  glm::vec4 pixel(int x, int y) {
    const EffectSet& effects = m_terms.effects;
    if (effects.hasAny(scalarProjections))
      return classifiedOnce();
    if (effects.has(Effect::xray))
      return xray();
    if (effects.has(Effect::isosurface))
      return surface();
    if (effects.has(Effect::hybrid))
      return compositeOverSurface(x, y);
    return composite();
  }

private:
  HWY_INLINE VF samplesFrom(int i) const { return hn::Iota(floats, static_cast<float>(i)); }

  HWY_INLINE V3 indexAt(VF step) const {
    return {hn::MulAdd(step, all(m_ray.stride.x), all(m_ray.first.x)),
            hn::MulAdd(step, all(m_ray.stride.y), all(m_ray.first.y)),
            hn::MulAdd(step, all(m_ray.stride.z), all(m_ray.first.z))};
  }

  HWY_INLINE Mask isBefore(VF step, int end) const { return hn::Lt(step, all(static_cast<float>(end))); }

  // The first sample of the group that holds one.
  int groupOf(int i) const { return i / lanes() * lanes(); }

  // Composites front to back what shows of a group. Transmittance is kept in double: small steps of long rays
  // take less from it than a float can tell.
  struct Sum {
    V3 color;
    double transmittance;
    bool hasEnded;
  };

  HWY_INLINE void add(Sum& sum, Mask seen, VF alpha, const V3& color) const {
    HWY_ALIGN float alphas[HWY_MAX_BYTES / 4];
    HWY_ALIGN float shares[HWY_MAX_BYTES / 4] = {};
    hn::Store(alpha, floats, alphas);
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(floats, seen, bytes);
    const double last = m_terms.lastTransmittance;
    for (std::uint32_t bits = bytes[0] | std::uint32_t{bytes[1]} << 8; bits != 0; bits &= bits - 1) {
      const int lane = std::countr_zero(bits);
      const double share = sum.transmittance * alphas[lane];
      shares[lane] = static_cast<float>(share);
      sum.transmittance -= share;
      if (sum.transmittance <= last) {
        sum.hasEnded = true;
        break;
      }
    }
    const VF weights = hn::Load(floats, shares);
    sum.color = {hn::MulAdd(weights, color.x, sum.color.x), hn::MulAdd(weights, color.y, sum.color.y),
                 hn::MulAdd(weights, color.z, sum.color.z)};
  }

  // What the samples of a group, or the pre-integrated steps around them, absorb.
  struct Absorbed {
    Mask seen;
    V3 color;
    VF opacity;    // over the unit distance
    VF extinction; // likewise
  };

  HWY_INLINE Absorbed absorbedBy(VF step, VF scalar) const {
    Absorbed absorbed;
    absorbed.seen = hn::And(isBefore(step, m_ray.count), m_function.mayBeSeen(scalar));
    if (hn::AllFalse(floats, absorbed.seen))
      return absorbed;
    const Classified material = m_function.at(scalar, absorbed.seen);
    absorbed.color = material.color;
    absorbed.opacity = material.opacity;
    absorbed.extinction = minusLog1mOpacity(material.opacity);
    return absorbed;
  }

  HWY_INLINE Absorbed absorbedOver(VF step) const {
    const VF first = hn::Sub(step, all(m_ray.offset));
    const VF before = m_field.scalarAt(indexAt(first));
    const VF behind = m_field.scalarAt(indexAt(hn::Add(first, all(1.0f))));
    Absorbed absorbed;
    absorbed.seen = hn::And(isBefore(step, m_ray.count), m_function.mayBeSeenBetween(before, behind));
    if (hn::AllFalse(floats, absorbed.seen))
      return absorbed;
    const Mean mean = m_function.meanBetween(before, behind, absorbed.seen);
    absorbed.color = mean.color;
    absorbed.extinction = mean.extinction;
    absorbed.opacity = oneMinusExpNeg(mean.extinction);
    return absorbed;
  }

  glm::vec4 composite() const {
    const EffectSet& effects = m_terms.effects;
    const bool isPreintegrated = effects.has(Effect::preintegration);
    const Light light(m_terms, m_ray);
    const EmptySteps empty(m_terms.empty, m_ray, isPreintegrated);
    Sum sum{zero(), 1.0, false};
    for (int i = groupOf(m_ray.from); i < m_ray.to && !sum.hasEnded;) {
      const int leap = empty.groupsFrom(i, lanes());
      if (leap > 0) {
        i += leap * lanes();
        continue;
      }
      const VF step = samplesFrom(i);
      i += lanes();
      const Cells cells = m_field.cellsAt(indexAt(step));
      const auto rows = m_field.rowsOf(cells);
      const Absorbed absorbed =
          isPreintegrated ? absorbedOver(step) : absorbedBy(step, m_field.scalarOf(rows, cells));
      if (hn::AllFalse(floats, absorbed.seen))
        continue;
      Gradients gradients{zero(), hn::Zero(floats), hn::Zero(floats)};
      if (effects.has(Effect::gradient))
        gradients = light.gradientsOf(m_field.gradientOf(rows, cells, m_terms.gradientScale));
      VF extinction = absorbed.extinction;
      if (effects.hasAny({Effect::opacityMap, Effect::opacityFactor, Effect::gradientOpacity}))
        extinction = minusLog1mOpacity(hn::Mul(absorbed.opacity, light.opacityFactor(gradients)));
      const VF alpha = oneMinusExpNeg(hn::Mul(extinction, all(m_ray.units)));
      add(sum, absorbed.seen, alpha, light.shaded(absorbed.color, gradients, step));
    }
    return pixelOf(sum);
  }

  HWY_INLINE glm::vec4 pixelOf(const Sum& sum) const {
    const auto alpha = static_cast<float>(1.0 - sum.transmittance);
    glm::vec3 color(hn::GetLane(hn::SumOfLanes(floats, sum.color.x)),
                    hn::GetLane(hn::SumOfLanes(floats, sum.color.y)),
                    hn::GetLane(hn::SumOfLanes(floats, sum.color.z)));
    // No colour exceeds 1, so what exceeds alpha is the rounding of a long sum.
    if (!m_terms.effects.has(Effect::unlimited))
      color = glm::min(color, glm::vec3(alpha));
    return {color, alpha};
  }

  glm::vec4 xray() const {
    const bool isPreintegrated = m_terms.effects.has(Effect::preintegration);
    const EmptySteps empty(m_terms.empty, m_ray, isPreintegrated);
    double depth = 0.0;
    for (int i = groupOf(m_ray.from); i < m_ray.to;) {
      const int leap = empty.groupsFrom(i, lanes());
      if (leap > 0) {
        i += leap * lanes();
        continue;
      }
      const VF step = samplesFrom(i);
      i += lanes();
      const Absorbed absorbed =
          isPreintegrated ? absorbedOver(step) : absorbedBy(step, m_field.scalarAt(indexAt(step)));
      if (hn::AllFalse(floats, absorbed.seen))
        continue;
      depth += hn::GetLane(hn::SumOfLanes(floats, hn::IfThenElseZero(absorbed.seen, absorbed.extinction)));
    }
    return glm::vec4(static_cast<float>(-std::expm1(-depth * m_ray.units)));
  }

  // The largest, smallest or mean scalar, classified once.
  glm::vec4 classifiedOnce() const {
    const EffectSet& effects = m_terms.effects;
    VF extreme = m_field.scalarAt(indexAt(hn::Zero(floats)));
    double total = 0.0;
    for (int i = 0; i < m_ray.count; i += lanes()) {
      const VF step = samplesFrom(i);
      const VF scalar = m_field.scalarAt(indexAt(step));
      const Mask isInside = isBefore(step, m_ray.count);
      if (effects.has(Effect::average))
        total += hn::GetLane(hn::SumOfLanes(floats, hn::IfThenElseZero(isInside, scalar)));
      else if (effects.has(Effect::mip))
        extreme = hn::Max(extreme, hn::IfThenElse(isInside, scalar, extreme));
      else
        extreme = hn::Min(extreme, hn::IfThenElse(isInside, scalar, extreme));
    }
    const float scalar = effects.has(Effect::average) ? static_cast<float>(total / m_ray.count)
                         : effects.has(Effect::mip)   ? hn::GetLane(hn::MaxOfLanes(floats, extreme))
                                                      : hn::GetLane(hn::MinOfLanes(floats, extreme));
    const Classified material = m_function.at(all(scalar), hn::FirstN(floats, 1));
    const float opacity = hn::GetLane(material.opacity);
    return {opacity * hn::GetLane(material.color.x), opacity * hn::GetLane(material.color.y),
            opacity * hn::GetLane(material.color.z), opacity};
  }

  // Where the field first reaches the isovalue, in steps behind sample 0; absent where it stays below.
  std::optional<float> firstHit() const {
    const float offset = m_ray.offset;
    const float exit = static_cast<float>(m_ray.count) - offset;
    const VF isovalue = all(m_terms.isovalue);
    if (hn::GetLane(m_field.scalarAt(indexAt(all(-offset)))) >= m_terms.isovalue)
      return -offset;
    const EmptySteps empty(m_terms.empty, m_ray, false);
    // The exit counts as the last sample.
    for (int i = 0; i <= m_ray.count;) {
      const int leap = empty.groupsFrom(i, lanes());
      if (leap > 0 && i + leap * lanes() <= m_ray.count) {
        i += leap * lanes();
        continue;
      }
      const VF step = hn::Min(samplesFrom(i), all(exit));
      const Mask isHit = hn::Ge(m_field.scalarAt(indexAt(step)), isovalue);
      const auto lane = hn::FindFirstTrue(floats, isHit);
      if (lane >= 0) {
        const int sample = i + static_cast<int>(lane);
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
      const VF scalar = m_field.scalarAt(indexAt(hn::Load(floats, middles)));
      std::uint8_t bytes[8] = {};
      hn::StoreMaskBits(floats, hn::Ge(scalar, all(m_terms.isovalue)), bytes);
      const std::uint32_t bits = bytes[0] | std::uint32_t{bytes[1]} << 8;
      for (int level = 0, node = 1; level < levels && done + level < halvings; ++level) {
        const bool isAbove = (bits >> (node - 1) & 1u) != 0;
        (isAbove ? above : below) = middles[node - 1];
        node = 2 * node + (isAbove ? 0 : 1);
      }
    }
    return above;
  }

  glm::vec3 surfaceColor(float hit) const {
    const Light light(m_terms, m_ray);
    const VF step = all(hit);
    Gradients gradients{zero(), hn::Zero(floats), hn::Zero(floats)};
    if (m_terms.effects.has(Effect::gradient)) {
      const Cells cells = m_field.cellsAt(indexAt(step));
      gradients = light.gradientsOf(m_field.gradientOf(m_field.rowsOf(cells), cells, m_terms.gradientScale));
    }
    const V3 color = light.shaded(all(m_terms.isoColor), gradients, step);
    return {hn::GetLane(color.x), hn::GetLane(color.y), hn::GetLane(color.z)};
  }

  glm::vec4 surface() const {
    const std::optional<float> hit = firstHit();
    return hit ? glm::vec4(surfaceColor(*hit), 1.0f) : glm::vec4(0.0f);
  }

  // Gathers what lies before the surface in steps of its own, then puts it over the surface.
  glm::vec4 compositeOverSurface(int x, int y) const {
    const std::optional<float> hit = firstHit();
    if (!hit)
      return composite();
    const glm::vec3 behind = surfaceColor(*hit);
    const std::optional<Ray> before = rayUpTo(m_terms, x, y, double(*hit) + m_ray.offset);
    if (!before)
      return {behind, 1.0f};
    const glm::vec4 front = Marcher(m_terms, *before).composite();
    return {glm::vec3(front) + (1.0f - front.a) * behind, 1.0f};
  }

  static constexpr int halvings = 14;

  const PictureTerms& m_terms;
  Field<kind> m_field;
  Function m_function;
  const Ray& m_ray;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
