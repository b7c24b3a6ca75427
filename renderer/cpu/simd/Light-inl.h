// SPDX-License-Identifier: GPL-3.0-or-later
// Blinn-Phong and Phong (paper eq. 1-4), the enhancement (eq. 7-9) and fog of several samples of one ray.
#if defined(LIMN_CPU_LIGHT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_LIGHT_INL_H
#undef LIMN_CPU_LIGHT_INL_H
#else
#define LIMN_CPU_LIGHT_INL_H
#endif

#include "cpu/rays/PictureTerms.h"
#include "cpu/simd/Function-inl.h"
#include "cpu/simd/Math-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// The unit gradient, its modulus, and r, of each sample.
struct Gradients {
  V3 direction;
  VF modulus;
  VF ratio;
};

/// What share of its light comes to each sample (DEFINITION section 11): S, of what is reflected, and A.
struct Reaching {
  VF direct, ambient;
};

/// How the samples of a ray are lit; what is the same for all rays of a picture decides the branches.
class Light {
public:
  Light(const PictureTerms& terms, const Ray& ray) : m_terms(terms), m_ray(ray) {}

  /// Of what the field gains over two voxels along each axis.
  HWY_INLINE Gradients gradientsOf(const V3& slope) const {
    const V3 gradient{hn::Mul(slope.x, all(m_terms.gradientScale.x)),
                      hn::Mul(slope.y, all(m_terms.gradientScale.y)),
                      hn::Mul(slope.z, all(m_terms.gradientScale.z))};
    Gradients result;
    result.modulus = hn::Sqrt(dot(gradient, gradient));
    const Mask hasLength = hn::Gt(result.modulus, hn::Zero(floats));
    const VF safe = hn::IfThenElse(hasLength, result.modulus, all(1.0f));
    result.direction = scaled(gradient, hn::Div(all(1.0f), safe));
    result.ratio = clamped(hn::Mul(result.modulus, all(m_terms.perReference)), 0.0f, 1.0f);
    if (m_terms.effects.has(Effect::gammaCurve))
      result.ratio = powerOrZero(result.ratio, all(m_terms.curve));
    if (m_terms.effects.has(Effect::logCurve))
      result.ratio = logCurve(result.ratio, m_terms.curve);
    return result;
  }

  /// The factor by which the gradient changes the opacity over the unit distance.
  HWY_NOINLINE VF opacityFactor(const Gradients& gradients) const {
    const CoefficientRange& range = m_terms.light.opacity;
    VF factor = all(1.0f);
    if (m_terms.effects.has(Effect::opacityMap))
      factor =
          mapped(gradients.ratio, static_cast<float>(range.atFlat), static_cast<float>(range.atBoundary));
    if (m_terms.effects.has(Effect::opacityFactor))
      factor = all(static_cast<float>(range.atFlat));
    if (m_terms.effects.has(Effect::gradientOpacity)) {
      const Mask every = hn::Ge(gradients.modulus, hn::Zero(floats));
      factor = hn::Mul(factor, Function(*m_terms.gradientCurve, nullptr).opacityAt(gradients.modulus, every));
    }
    return factor;
  }

  /// The normals of samples `step` steps behind sample 0 of the ray; zero where there is none.
  HWY_INLINE V3 normalOf(const Gradients& gradients, VF step) const {
    V3 normal = zero();
    if (m_terms.effects.has(Effect::gradient)) {
      const Mask hasNormal = hn::Gt(gradients.modulus, all(m_terms.flatModulus));
      normal = {hn::IfThenElseZero(hasNormal, hn::Neg(gradients.direction.x)),
                hn::IfThenElseZero(hasNormal, hn::Neg(gradients.direction.y)),
                hn::IfThenElseZero(hasNormal, hn::Neg(gradients.direction.z))};
    }
    return m_terms.effects.has(Effect::cutFaces) ? normalNearCut(step, normal) : normal;
  }

  /// The colour of materials there, lit and fogged.
  HWY_INLINE V3 shaded(const V3& material, const Gradients& gradients, VF step) const {
    return m_terms.effects.has(Effect::lighting)
               ? shaded(material, normalOf(gradients, step), gradients.ratio, step, nullptr)
               : withFog(material, step);
  }

  /// The same with their normals; all light comes where `reaching` is null.
  HWY_INLINE V3 shaded(const V3& material, const V3& normal, VF ratio, VF step,
                       const Reaching* reaching) const {
    return withFog(lit(material, normal, ratio, reaching), step);
  }

private:
  HWY_INLINE V3 withFog(const V3& color, VF step) const {
    return m_terms.effects.hasAny(fogs) ? fogged(color, step) : color;
  }

  HWY_INLINE VF highlight(V3 normal, VF ratio) const {
    const LightingTerms& light = m_terms.light;
    const auto low = static_cast<float>(light.exponent.atFlat);
    const auto high = static_cast<float>(light.exponent.atBoundary);
    const VF exponent = m_terms.effects.has(Effect::exponentMap) ? mapped(ratio, low, high) : all(low);
    VF term;
    if (m_terms.effects.has(Effect::phong)) {
      // Mirror the light's direction at the normal and compare it with the viewer's.
      VF towardsLight = dot(normal, all(m_ray.toLight));
      if (m_terms.effects.has(Effect::twoSided)) {
        const Mask isAway = hn::Lt(towardsLight, hn::Zero(floats));
        normal = chosen(isAway, {hn::Neg(normal.x), hn::Neg(normal.y), hn::Neg(normal.z)}, normal);
        towardsLight = hn::Abs(towardsLight);
      }
      const VF twice = hn::Add(towardsLight, towardsLight);
      const V3 mirrored{hn::MulSub(twice, normal.x, all(m_ray.toLight.x)),
                        hn::MulSub(twice, normal.y, all(m_ray.toLight.y)),
                        hn::MulSub(twice, normal.z, all(m_ray.toLight.z))};
      term = hn::IfThenElseZero(hn::Gt(towardsLight, hn::Zero(floats)),
                                blinnTerm(dot(mirrored, all(m_ray.toViewer)), exponent));
    } else {
      VF alignment = dot(normal, all(m_ray.halfway));
      if (m_terms.effects.has(Effect::twoSided))
        alignment = hn::Abs(alignment);
      term = blinnTerm(alignment, exponent);
    }
    if (m_terms.effects.has(Effect::energyFactor))
      term = hn::Mul(term, energyFactor(exponent, high));
    if (m_terms.effects.has(Effect::significance))
      term = hn::Mul(term, significanceWeight(static_cast<float>(light.significance->low),
                                              static_cast<float>(light.significance->high), ratio));
    return term;
  }

  HWY_INLINE V3 lit(const V3& material, const V3& normal, VF ratio, const Reaching* reaching) const {
    const LightingTerms& light = m_terms.light;
    VF ofMaterial = all(static_cast<float>(light.ambient));
    if (reaching)
      ofMaterial = hn::Mul(ofMaterial, reaching->ambient);
    if (m_terms.effects.has(Effect::diffuse)) {
      VF facing = dot(normal, all(m_ray.toLight));
      facing = m_terms.effects.has(Effect::twoSided) ? hn::Abs(facing) : hn::Max(facing, hn::Zero(floats));
      if (reaching)
        facing = hn::Mul(facing, reaching->direct);
      ofMaterial = hn::MulAdd(all(static_cast<float>(light.diffuse)), facing, ofMaterial);
    }
    VF ofLight = hn::Zero(floats);
    if (m_terms.effects.has(Effect::specular)) {
      VF term = hn::Mul(all(static_cast<float>(light.specular)), highlight(normal, ratio));
      if (reaching)
        term = hn::Mul(term, reaching->direct);
      (m_terms.effects.has(Effect::specularOfLight) ? ofLight : ofMaterial) =
          hn::Add(m_terms.effects.has(Effect::specularOfLight) ? ofLight : ofMaterial, term);
    }
    V3 sum{hn::MulAdd(material.x, ofMaterial, ofLight), hn::MulAdd(material.y, ofMaterial, ofLight),
           hn::MulAdd(material.z, ofMaterial, ofLight)};
    if (m_terms.effects.has(Effect::unlimited))
      return sum;
    if (m_terms.effects.has(Effect::knee))
      sum = knee(sum, static_cast<float>(*light.knee));
    return clamped(sum, 0.0f, 1.0f);
  }

  // Near a face that the crop box cuts, that face's outward normal takes the gradient's place; at equal
  // distance the first axis's. In the middle of a thin slab it is the face through which the ray enters.
  HWY_INLINE V3 normalNearCut(VF step, V3 normal) const {
    VF nearest = all(1.0f); // unit length
    for (int axis = 2; axis >= 0; --axis) {
      const auto spacing = static_cast<float>(m_terms.spacing[axis]);
      const VF at = hn::MulAdd(step, all(m_ray.stride[axis]), all(m_ray.firstIndex[axis]));
      const VF fromLower =
          hn::Mul(hn::Sub(at, all(static_cast<float>(m_terms.cut.lower[axis]))), all(spacing));
      const VF fromUpper =
          hn::Mul(hn::Sub(all(static_cast<float>(m_terms.cut.upper[axis])), at), all(spacing));
      const VF nearer = hn::Min(fromLower, fromUpper);
      const Mask isChosen = hn::Le(nearer, nearest);
      nearest = hn::IfThenElse(isChosen, nearer, nearest);
      const Mask isTie = hn::Le(hn::Abs(hn::Sub(fromUpper, fromLower)), all(1e-3f));
      const VF ofTie = all(m_ray.stride[axis] > 0.0f ? -1.0f : 1.0f);
      const VF side =
          hn::IfThenElse(isTie, ofTie, hn::IfThenElse(hn::Lt(fromLower, fromUpper), all(-1.0f), all(1.0f)));
      V3 face = zero();
      (axis == 0 ? face.x : axis == 1 ? face.y : face.z) = side;
      normal = chosen(isChosen, face, normal);
    }
    return normal;
  }

  HWY_INLINE V3 fogged(const V3& color, VF step) const {
    const VF z = hn::MulAdd(step, all(m_ray.strideDepth), all(m_ray.firstDepth));
    const VF own = m_terms.effects.has(Effect::fogLinear) ? fogLinear(z, m_terms.fogStart, m_terms.fogEnd)
                   : m_terms.effects.has(Effect::fogExp)  ? fogExp(z, m_terms.fogStart, m_terms.fogDensity)
                                                          : fogExp2(z, m_terms.fogStart, m_terms.fogDensity);
    const VF share = hn::Sub(all(1.0f), own);
    return {mix(color.x, all(m_terms.fogColor.x), share), mix(color.y, all(m_terms.fogColor.y), share),
            mix(color.z, all(m_terms.fogColor.z), share)};
  }

  const PictureTerms& m_terms;
  const Ray& m_ray;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
