// SPDX-License-Identifier: GPL-3.0-or-later
// What comes of light to places (DEFINITION section 11) from a grid of nodes, which stands for what is some
// way off. Along a light of a direction M changes within a voxel: what stands near is looked at from the
// place.
#if defined(LIMN_CPU_NEAR_LIGHT_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_NEAR_LIGHT_INL_H
#undef LIMN_CPU_NEAR_LIGHT_INL_H
#else
#define LIMN_CPU_NEAR_LIGHT_INL_H
#endif

#include "cpu/rays/PictureTerms.h"
#include "cpu/simd/LightGrid-inl.h"
#include "cpu/simd/LightMarch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// M at several places.
template <VoxelSource::Kind kind>
class NearLight {
public:
  HWY_INLINE NearLight(const PictureTerms& terms, const LightMarch<kind>& march, const V3& index)
      : m_terms(terms), m_march(march), m_index(index) {}

  /// Of the light that has a direction: along its middle.
  HWY_INLINE VF direct() const {
    const TravelTerms& travel = m_terms.travel;
    const glm::vec3 towards(m_terms.towardsLight);
    const auto reach = static_cast<float>(travel.look.directAway);
    const glm::vec3 way = reach * towards / glm::vec3(m_terms.spacing);
    const V3 away{hn::Add(m_index.x, all(way.x)), hn::Add(m_index.y, all(way.y)),
                  hn::Add(m_index.z, all(way.z))};
    const VF far = GridLight(travel, away).direct();
    if (!travel.look.looksNear || hn::AllFalse(floats, hn::Gt(far, hn::Zero(floats))))
      return far;
    if (m_terms.effects.has(Effect::isosurface)) { // which is there or not, and met once by a ray
      const Mask every = hn::Ge(all(1.0f), hn::Zero(floats));
      return hn::Mul(m_march.transmittance(m_index, all(towards), travel.from, reach, 0.25f, every), far);
    }
    const float length = (reach - travel.from) / looks;
    VF depth = hn::Zero(floats);
    for (int look = 0; look < looks; ++look) {
      const float at = travel.from + (static_cast<float>(look) + 0.5f) * length;
      depth = hn::MulAdd(m_march.extinctionAlong(m_index, all(towards), at), all(length), depth);
    }
    return hn::Mul(expNeg(depth), far);
  }

  /// Of ambient light, around normals of unit length, or zero.
  HWY_INLINE VF ambient(const V3& normal) const {
    const glm::vec3 way = static_cast<float>(m_terms.travel.look.ambientAway) / glm::vec3(m_terms.spacing);
    const V3 away{hn::MulAdd(normal.x, all(way.x), m_index.x), hn::MulAdd(normal.y, all(way.y), m_index.y),
                  hn::MulAdd(normal.z, all(way.z), m_index.z)};
    return GridLight(m_terms.travel, away).ambient(normal);
  }

private:
  static constexpr int looks = 2; // along the light

  const PictureTerms& m_terms;
  const LightMarch<kind>& m_march;
  V3 m_index;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
