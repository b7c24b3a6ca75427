// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <cstdint>
#include <string>
#include <vector>

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
  earlyTermination,
  emptySpaceSkipping,
  longRays,
  denseFunctions,
  sampleCounts
};
inline constexpr int effectCount = static_cast<int>(Effect::sampleCounts) + 1;

struct EffectDescription {
  const char* name;   ///< as `limn effects` prints it
  const char* define; ///< as the shaders test it
  const char* meaning;
};

const EffectDescription& describe(Effect effect);

/// A set of effects: the key of a shader program.
class EffectSet {
public:
  bool has(Effect effect) const { return (m_bits >> static_cast<int>(effect) & 1u) != 0; }
  EffectSet with(Effect effect) const { return EffectSet(m_bits | 1u << static_cast<int>(effect)); }
  EffectSet without(Effect effect) const { return EffectSet(m_bits & ~(1u << static_cast<int>(effect))); }
  std::uint32_t bits() const { return m_bits; }
  static EffectSet fromBits(std::uint32_t bits) { return EffectSet(bits); }
  EffectSet() = default;
  auto operator<=>(const EffectSet&) const = default;

private:
  explicit EffectSet(std::uint32_t bits) : m_bits(bits) {}
  std::uint32_t m_bits = 0;
};

/// The set with every effect dropped that cannot matter without another, and added that another needs: sets
/// that draw the same picture become the same set.
EffectSet canonical(EffectSet effects);

/// Facts about data and limits on which effects depend beside the scene's own numbers.
struct SceneFacts {
  double longestRaySamples = 0.0; ///< before the limit, see RayFrame
  bool canSkipEmptySpace = false; ///< the renderer knows where nothing can be seen
  bool hasDenseFunctions = false; ///< control points so close that a table holds several in one bin
};

/// Why an effect is needed or not, a phrase for a reader.
struct EffectReason {
  Effect effect;
  bool isNeeded = false;
  std::string reason;
};

/// The effects that a scene calls for, canonical, with one reason per effect in the order of the enumeration.
struct EffectPlan {
  EffectSet effects;
  std::vector<EffectReason> reasons;
};

/// Depends on the scene's numbers but on no camera pose and, but for crowded points (`hasDenseFunctions`), on
/// no control point, so that editing the transfer function or turning the view asks for no other program.
EffectPlan requiredEffects(const Scene& scene, const SceneFacts& facts);

/// Throws Error (usage) naming what no renderer draws yet: projections other than composite, forced
/// pre-integration, jitter.
void requireDrawable(const Scene& scene);

} // namespace limn
