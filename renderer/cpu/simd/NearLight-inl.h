// SPDX-License-Identifier: GPL-3.0-or-later
// What comes of light to places (DEFINITION section 11) from grids of nodes, which stand for what is some way
// off. M changes within a voxel: at rest what stands near is looked at from the place, towards the light and
// along the normal.
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
    const glm::vec3 way = static_cast<float>(travel.look.directAsked) * towards / glm::vec3(m_terms.spacing);
    const V3 away{hn::Add(m_index.x, all(way.x)), hn::Add(m_index.y, all(way.y)),
                  hn::Add(m_index.z, all(way.z))};
    const VF far = GridLight(travel.found.directNodes, travel.toDirect, away).direct(*travel.found.direct);
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
    const TravelTerms& travel = m_terms.travel;
    const glm::vec3 way = static_cast<float>(travel.look.ambientAway) / glm::vec3(m_terms.spacing);
    const V3 away{hn::MulAdd(normal.x, all(way.x), m_index.x), hn::MulAdd(normal.y, all(way.y), m_index.y),
                  hn::MulAdd(normal.z, all(way.z), m_index.z)};
    const VF far =
        GridLight(travel.found.ambientNodes, travel.toAmbient, away).ambient(*travel.found.ambient, normal);
    return travel.look.looksNear ? hn::Mul(far, throughLayers(normal)) : far;
  }

private:
  static constexpr int looks = 6; // along the light

  // What comes of ambient light past the layers above places; all where there is no normal.
  HWY_NOINLINE VF throughLayers(const V3& normal) const {
    const LayerLengths& lengths = m_terms.travel.layers;
    constexpr std::size_t layers = std::tuple_size_v<LayerLengths::value_type>;
    constexpr float height = static_cast<float>(LightLook::layersReach) / layers;
    VF extinctions[layers];
    VF most = hn::Zero(floats);
    for (std::size_t layer = 0; layer < layers; ++layer) {
      extinctions[layer] =
          m_march.extinctionAlong(m_index, normal, (static_cast<float>(layer) + 0.5f) * height);
      most = hn::Max(most, extinctions[layer]);
    }
    const Mask isDimmed = hn::And(hn::Gt(most, hn::Zero(floats)), hn::Gt(dot(normal, normal), all(0.25f)));
    if (hn::AllFalse(floats, isDimmed))
      return all(1.0f);
    VF sum = hn::Zero(floats);
    for (const LayerLengths::value_type& path : lengths) {
      VF depth = hn::Zero(floats);
      for (std::size_t layer = 0; layer < layers; ++layer)
        depth = hn::MulAdd(extinctions[layer], all(path[layer]), depth);
      sum = hn::Add(sum, expNeg(depth));
    }
    const VF mean = hn::Mul(sum, all(1.0f / static_cast<float>(lengths.size())));
    return hn::IfThenElse(isDimmed, mean, all(1.0f));
  }

  const PictureTerms& m_terms;
  const LightMarch<kind>& m_march;
  V3 m_index;
};

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
