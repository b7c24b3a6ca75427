// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <compare>
#include <cstdint>
#include <initializer_list>

namespace limn {

/// What a picture may ask of a renderer beyond classifying and compositing. Each has one row in `describe`,
/// one clause in `requiredEffects`, one guard in the shaders and one term in the reference.
enum class Effect : std::uint8_t {
  lighting,
  gradient,
  diffuse,
  specular,
  phong,
  twoSided,
  fixedLight,
  specularOfLight,
  exponentMap,
  opacityMap,
  opacityFactor,
  gammaCurve,
  logCurve,
  gradientOpacity,
  energyFactor,
  significance,
  knee,
  fogLinear,
  fogExp,
  fogExp2,
  cutFaces,
  shadow,
  occlusion,
  smoothNormals,
  physical,
  region,
  labelLooks,
  mip,
  minip,
  average,
  xray,
  isosurface,
  hybrid,
  preintegration,
  jitter,
  earlyTermination,
  emptySpaceSkipping,
  longRays,
  denseFunctions,
  localSteps,
  ownWeights,
  unlimited,
  sampleCounts
};
inline constexpr int effectCount = static_cast<int>(Effect::sampleCounts) + 1;

/// What an effect is called.
struct EffectDescription {
  const char* name;   ///< one word, for lists and tests
  const char* define; ///< as the shaders test it
  const char* meaning;
};

/// The row of an effect.
const EffectDescription& describe(Effect effect);

/// A set of effects: the key of a shader program.
class EffectSet {
public:
  EffectSet() = default;
  EffectSet(std::initializer_list<Effect> effects) {
    for (const Effect effect : effects)
      m_bits |= bit(effect);
  }
  bool has(Effect effect) const { return (m_bits & bit(effect)) != 0; }
  bool hasAny(EffectSet others) const { return (m_bits & others.m_bits) != 0; }
  bool isEmpty() const { return m_bits == 0; }
  int count() const { return std::popcount(m_bits); }
  EffectSet with(EffectSet others) const { return EffectSet(m_bits | others.m_bits); }
  EffectSet with(Effect effect) const { return EffectSet(m_bits | bit(effect)); }
  EffectSet without(EffectSet others) const { return EffectSet(m_bits & ~others.m_bits); }
  EffectSet without(Effect effect) const { return EffectSet(m_bits & ~bit(effect)); }
  auto operator<=>(const EffectSet&) const = default;

private:
  explicit EffectSet(std::uint64_t bits) : m_bits(bits) {}
  static std::uint64_t bit(Effect effect) { return std::uint64_t{1} << static_cast<int>(effect); }
  std::uint64_t m_bits = 0;
};

/// The projections that classify one value of each ray (classifiesOnce).
inline const EffectSet scalarProjections{Effect::mip, Effect::minip, Effect::average};

/// How the gradient, or the model, changes an opacity before it becomes an extinction.
inline const EffectSet opacityChanges{Effect::opacityMap, Effect::opacityFactor, Effect::gradientOpacity};

/// What asks at each sample how much light comes so far (DEFINITION section 11).
inline const EffectSet travellingLight{Effect::shadow, Effect::occlusion};

/// Of which a picture has at most one.
inline const EffectSet fogs{Effect::fogLinear, Effect::fogExp, Effect::fogExp2};

/// Whether a program of these effects reads the normalised gradient modulus r.
bool usesRatio(EffectSet effects);

/// The set with every effect dropped that cannot matter without another, and added that another needs: sets
/// that draw the same picture become the same set.
EffectSet canonical(EffectSet effects);

/// The set without some effects and without all that cannot be had without them: what is left to draw when
/// they are left out to measure what they cost. Canonical.
EffectSet leavingOut(EffectSet effects, EffectSet leftOut);

/// Whether a program of `effects` draws the picture that calls for `needed`, bit for bit, with the uniforms
/// of that picture's scene: it has all that is needed, and what it has beyond has a neutral value (a fog of
/// density 0, an exponent range of width 0, …).
bool canStandIn(EffectSet effects, EffectSet needed);

/// The largest program that can stand in for a set: every effect that has a neutral value compiled in.
EffectSet withAllNeutral(EffectSet needed);

} // namespace limn
