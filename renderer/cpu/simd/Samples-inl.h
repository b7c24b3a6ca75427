// SPDX-License-Identifier: GPL-3.0-or-later
// The samples of one ray: what lies there, what it absorbs and how it is lit. As many as the registers hold
// are computed together.
#if defined(LIMN_CPU_SAMPLES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef LIMN_CPU_SAMPLES_INL_H
#undef LIMN_CPU_SAMPLES_INL_H
#else
#define LIMN_CPU_SAMPLES_INL_H
#endif

#include "cpu/rays/PictureTerms.h"
#include "cpu/simd/Field-inl.h"
#include "cpu/simd/Function-inl.h"
#include "cpu/simd/Light-inl.h"
#include "cpu/simd/LightMarch-inl.h"
#include "cpu/simd/Looks-inl.h"
#include "cpu/simd/NearLight-inl.h"
#include "cpu/simd/SpreadLight-inl.h"

HWY_BEFORE_NAMESPACE();
namespace limn::cpu::HWY_NAMESPACE {

/// What is read and computed at places along one ray, several of them at a time.
template <VoxelSource::Kind kind>
struct Samples {
  Samples(const PictureTerms& ofPicture, const Ray& along)
      : terms(ofPicture), ray(along), field(ofPicture.voxels),
        function(*ofPicture.function, ofPicture.segments), light(ofPicture, along), looks(ofPicture) {}

  /// Voxel indices `step` steps behind sample 0.
  HWY_INLINE V3 indexAt(VF step) const {
    return {hn::MulAdd(step, all(ray.stride.x), all(ray.first.x)),
            hn::MulAdd(step, all(ray.stride.y), all(ray.first.y)),
            hn::MulAdd(step, all(ray.stride.z), all(ray.first.z))};
  }

  HWY_INLINE VF scalarAt(VF step) const { return field.scalarAt(indexAt(step)); }

  /// What the kept region leaves of the opacity.
  HWY_NOINLINE VF weightAt(VF step) const {
    const V3 index = indexAt(step);
    return terms.region.kind == VoxelSource::Kind::byte
               ? Field<VoxelSource::Kind::byte>(terms.region).scalarAt(index)
               : Field<VoxelSource::Kind::half>(terms.region).scalarAt(index);
  }

  /// Those of some samples that the region keeps where samples are taken or left.
  HWY_INLINE Mask kept(VF step, Mask wanted) const {
    return terms.effects.has(Effect::region) ? hn::And(wanted, hn::Ge(weightAt(step), all(0.5f))) : wanted;
  }

  /// Those of some samples of which the region leaves something; what it leaves of their opacities, known to
  /// be all where they are whole. As if the others lay in empty space: which samples a ray looks at changes
  /// no bit.
  HWY_INLINE Mask weighed(VF step, Mask seen, bool areWhole, VF& opacity) const {
    if (areWhole || !terms.effects.has(Effect::region) || hn::AllFalse(floats, seen))
      return seen;
    const VF weight = weightAt(step);
    opacity = hn::Mul(opacity, weight);
    return hn::And(seen, hn::Gt(weight, hn::Zero(floats)));
  }

  /// What samples, or the pre-integrated steps around them, absorb.
  struct Absorbed {
    Mask seen;
    V3 color;
    VF opacity;    // over the unit distance; of looks, which have no common one, anything
    VF extinction; // likewise
  };

  /// The scalars `step` steps behind sample 0; `areWhole` where a region is known to keep all of them.
  HWY_NOINLINE Absorbed absorbedBy(VF scalar, VF step, Mask wanted, bool areWhole, bool withColor) const {
    Absorbed absorbed;
    if (looks.areAny()) {
      const Looks::Mixed mixed = looks.mixedAt(indexAt(step), scalar, all(1.0f), wanted,
                                               withColor ? Looks::Colors::ofSeen : Looks::Colors::ofNone);
      return {mixed.seen, mixed.color, mixed.extinction, mixed.extinction};
    }
    const Mask opaque = function.opacityWhereSeen(scalar, wanted, absorbed.opacity);
    absorbed.seen = weighed(step, opaque, areWhole, absorbed.opacity);
    if (hn::AllFalse(floats, absorbed.seen))
      return absorbed;
    if (withColor)
      absorbed.color = function.colorAt(scalar, absorbed.seen);
    absorbed.extinction = minusLog1mOpacity(absorbed.opacity);
    return absorbed;
  }

  /// Of the step around each sample. `perUnit` receives, where labels have looks, how many unit distances of
  /// its look are in a length where a step lies within one; it stays where a step's sample stands for it.
  HWY_NOINLINE Absorbed absorbedOver(VF step, Mask wanted, bool areWhole, VF& perUnit) const {
    const VF first = hn::Sub(step, all(ray.offset));
    const VF before = field.scalarAt(indexAt(first));
    const VF behind = field.scalarAt(indexAt(hn::Add(first, all(1.0f))));
    if (looks.areAny())
      return absorbedByLook(first, step, before, behind, wanted, perUnit);
    Absorbed absorbed;
    absorbed.seen = hn::And(wanted, function.mayBeSeenBetween(before, behind));
    if (hn::AllFalse(floats, absorbed.seen))
      return absorbed;
    const Mean mean = function.meanBetween(before, behind, absorbed.seen);
    absorbed.color = mean.color;
    absorbed.extinction = mean.extinction;
    absorbed.opacity = oneMinusExpNeg(mean.extinction);
    if (!areWhole && terms.effects.has(Effect::region)) {
      const VF weight = weightAt(step);
      absorbed.seen = hn::And(absorbed.seen, hn::Gt(weight, hn::Zero(floats)));
      absorbed.opacity = hn::Mul(absorbed.opacity, weight);
      // All of it is the mean itself: whether weights are read changes no bit.
      absorbed.extinction =
          hn::IfThenElse(hn::Ge(weight, all(1.0f)), mean.extinction, minusLog1mOpacity(absorbed.opacity));
    }
    return absorbed;
  }

  /// The same where labels have looks: within one its means, elsewhere the sample in the middle
  /// (DEFINITION section 10).
  HWY_NOINLINE Absorbed absorbedByLook(VF first, VF step, VF before, VF behind, Mask wanted,
                                       VF& perUnit) const {
    const V3 middle = indexAt(step);
    const Looks::Within within =
        looks.within(indexAt(first), middle, indexAt(hn::Add(first, all(1.0f))), before, behind, wanted);
    perUnit = hn::IfThenElse(within.seen, within.perUnit, perUnit);
    Absorbed absorbed{within.seen, within.color, within.opacity, hn::Mul(within.extinction, within.perUnit)};
    const Mask others = hn::AndNot(within.steps, wanted);
    if (hn::AllFalse(floats, others))
      return absorbed;
    const Looks::Mixed mixed =
        looks.mixedAt(middle, field.scalarAt(middle), all(1.0f), others,
                      terms.effects.has(Effect::xray) ? Looks::Colors::ofNone : Looks::Colors::ofSeen);
    const Mask seen = hn::And(others, mixed.seen);
    absorbed.seen = hn::Or(absorbed.seen, seen);
    absorbed.color = chosen(seen, mixed.color, absorbed.color);
    absorbed.extinction = hn::IfThenElse(seen, mixed.extinction, absorbed.extinction);
    return absorbed;
  }

  /// What a sample says of the piece for which it stands.
  struct Shaded {
    Mask seen;
    V3 color;
    VF extinction; // over the unit distance
  };

  /// The samples at `step`, where `wanted`.
  HWY_NOINLINE Shaded at(VF step, Mask wanted) const {
    const EffectSet& effects = terms.effects;
    VF perUnit = hn::Zero(floats);
    const Absorbed absorbed = effects.has(Effect::preintegration)
                                  ? absorbedOver(step, wanted, false, perUnit)
                                  : absorbedBy(scalarAt(step), step, wanted, false, true);
    Shaded result{absorbed.seen, zero(), hn::Zero(floats)};
    if (hn::AllFalse(floats, absorbed.seen))
      return result;
    result.extinction = absorbed.extinction;
    if (effects.has(Effect::xray))
      return result;
    Gradients gradients{zero(), hn::Zero(floats), hn::Zero(floats)};
    if (effects.has(Effect::gradient))
      gradients = light.gradientsOf(slopeAt(terms, field, indexAt(step), lanes()));
    if (effects.hasAny(opacityChanges))
      result.extinction = minusLog1mOpacity(hn::Mul(absorbed.opacity, light.opacityFactor(gradients)));
    result.color = shaded(absorbed.color, gradients, step);
    return result;
  }

  /// The colour of materials, lit and fogged.
  HWY_INLINE V3 shaded(const V3& material, const Gradients& gradients, VF step) const {
    SpreadTurn alone;
    return shaded(material, gradients, step, all(1.0f), alone);
  }

  /// The same of samples that take `shares` of the pixel, behind those that `turn` tells of.
  HWY_INLINE V3 shaded(const V3& material, const Gradients& gradients, VF step, VF shares,
                       SpreadTurn& turn) const {
    return HWY_LIKELY(!terms.effects.hasAny(travellingLight))
               ? light.shaded(material, gradients, step)
               : shadedPast(material, gradients, step, shares, turn);
  }

  /// The same with what stands in the way of the light.
  HWY_NOINLINE V3 shadedPast(const V3& material, const Gradients& gradients, VF step, VF shares,
                             SpreadTurn& turn) const {
    const V3 index = indexAt(step);
    const V3 normal = light.normalOf(gradients, step);
    Reaching comes{all(1.0f), all(1.0f)};
    const LightMarch<kind> march(terms, field, function, light, looks);
    if (terms.travel.spread > 0) {
      comes = SpreadLight<kind>(terms, march, ray.pixel).of(index, normal, shares, turn);
    } else {
      const NearLight<kind> near(terms, march, index);
      if (terms.effects.has(Effect::shadow))
        comes.direct = near.direct();
      if (terms.effects.has(Effect::occlusion))
        comes.ambient = near.ambient(normal);
    }
    const Reaching reaching{dimmed(terms.light.shadow.strength, comes.direct),
                            dimmed(terms.light.occlusion.strength, comes.ambient)};
    return light.shaded(material, normal, gradients.ratio, step, &reaching);
  }

  HWY_INLINE static VF dimmed(double strength, VF comes) {
    const auto s = static_cast<float>(strength);
    return hn::MulAdd(all(s), comes, all(1.0f - s));
  }

  /// A surface of the isovalue, lit.
  HWY_NOINLINE glm::vec3 surfaceAt(float step) const {
    Gradients gradients{zero(), hn::Zero(floats), hn::Zero(floats)};
    if (terms.effects.has(Effect::gradient))
      gradients = light.gradientsOf(slopeAt(terms, field, indexAt(all(step)), 1));
    SpreadTurn alone;
    const VF share = hn::IfThenElseZero(hn::FirstN(floats, 1), all(1.0f));
    const V3 color = shaded(all(terms.isoColor), gradients, all(step), share, alone);
    return {hn::GetLane(color.x), hn::GetLane(color.y), hn::GetLane(color.z)};
  }

  const PictureTerms& terms;
  const Ray& ray;
  Field<kind> field;
  Function function;
  Light light;
  Looks looks;
};

/// What a ray has gathered, front to back. Transmittance is kept in double: small steps of long rays take
/// less from it than a float can tell.
struct Sum {
  V3 color;
  double transmittance;
  bool hasEnded;
};

/// Premultiplied colour and alpha.
HWY_INLINE glm::vec4 pixelOf(const Sum& sum, EffectSet effects) {
  const auto alpha = static_cast<float>(1.0 - sum.transmittance);
  if (effects.has(Effect::xray))
    return glm::vec4(alpha);
  glm::vec3 color(hn::GetLane(hn::SumOfLanes(floats, sum.color.x)),
                  hn::GetLane(hn::SumOfLanes(floats, sum.color.y)),
                  hn::GetLane(hn::SumOfLanes(floats, sum.color.z)));
  // No colour exceeds 1, so what exceeds alpha is the rounding of a long sum.
  if (!effects.has(Effect::unlimited))
    color = glm::min(color, glm::vec3(alpha));
  return {color, alpha};
}

} // namespace limn::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
