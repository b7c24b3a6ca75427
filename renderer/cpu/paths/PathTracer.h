// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/paths/FreeWay.h"
#include "cpu/paths/Medium.h"
#include "cpu/paths/PathRandom.h"
#include "cpu/paths/PathTerms.h"
#include "cpu/paths/Scattering.h"
#include "scene/basics/StableMath.h"
#include "scene/light/Boundary.h"

#include <glm/glm.hpp>

#include <optional>

namespace limn::cpu {

/// The sky of the terms (DEFINITION section 12).
struct LinearSky {
  const PathTerms& terms;
  /// The radiance from a direction.
  float operator()(const glm::vec3& from) const {
    const float share = 0.5f + 0.5f * glm::dot(from, terms.up);
    return terms.skyBelow + share * (terms.skyAbove - terms.skyBelow);
  }
};

/// Random paths from the camera into the volume and on to the lights (DEFINITION section 12).
template <class T, class SkyOf = LinearSky>
class PathTracer {
public:
  PathTracer(const PathTerms& terms, const SkyOf& sky)
      : m_terms(terms), m_medium(terms), m_way(terms, m_medium), m_sky(sky) {}

  /// The radiance that one path finds of what the ray meets; absent where it meets nothing. `mostTries`: so
  /// often another first collision is looked for, which does not change its place where there is one.
  std::optional<glm::vec3> radiance(const PathStart& start, PathRandom& random, int mostTries = 1) const {
    for (int n = 0; n < mostTries; ++n)
      if (const auto met = m_way.collision(start.place, start.direction, start.length, random))
        return from(*met, start.direction, m_terms.isHeadlight ? -start.direction : m_terms.towardsKey,
                    random);
    return std::nullopt;
  }

  /// What a path first meets.
  struct Met {
    glm::vec3 albedo, normal; // turned to the viewer; 0 where the field is flat
    float depth = 0.0f;       // behind where it begins, lengths
  };

  /// Absent where it meets nothing; `mostTries` as above.
  std::optional<Met> firstMet(const PathStart& start, PathRandom& random, int mostTries = 1) const {
    for (int n = 0; n < mostTries; ++n)
      if (const auto met = m_way.collision(start.place, start.direction, start.length, random)) {
        const glm::vec3 gradient = m_medium.gradientAt(*met);
        const float modulus = glm::length(gradient);
        const glm::vec3 normal = modulus > m_terms.flatModulus ? gradient / modulus : glm::vec3(0.0f);
        return Met{m_medium.albedoAt(*met), glm::dot(normal, start.direction) > 0.0f ? -normal : normal,
                   glm::length((*met - start.place) / m_terms.perLength)};
      }
    return std::nullopt;
  }

  /// The radiance that comes along `direction` from a collision at a place.
  glm::vec3 from(glm::vec3 place, glm::vec3 direction, const glm::vec3& towardsKey,
                 PathRandom& random) const {
    glm::vec3 found(0.0f);
    glm::vec3 weight(1.0f);
    for (int events = 1;; ++events) {
      const glm::vec3 albedo = m_medium.albedoAt(place);
      const std::optional<Surface> surface = surfaceAt(place, direction, albedo, random);

      // Look at the key.
      if (m_terms.keyFluence > 0.0f) {
        const glm::vec3 key = withinCone(towardsKey, m_terms.keyCosine, random);
        const glm::vec3 worth = surface ? surface->reflected(-direction, key)
                                        : albedo * phase(m_terms.anisotropy, glm::dot(direction, key));
        const glm::vec3 most = weight * worth * m_terms.keyFluence;
        if (std::max({most.r, most.g, most.b}) > 0.0f)
          found += most * m_way.transmittance(place, key, random);
      }

      // Go on, as the event scatters.
      glm::vec3 next;
      if (surface) {
        weight *= surface->drawn(-direction, random, next);
      } else {
        weight *= albedo;
        next = phaseDirection(m_terms.anisotropy, direction, random);
      }
      direction = next;
      if (!goesOn(events, weight, random))
        return found;

      // The way itself asks how much of the sky comes through.
      const auto met = m_way.collision(place, direction, lengthInBox(m_terms, place, direction), random);
      if (!met)
        return found + weight * m_sky(direction);
      place = *met;
    }
  }

private:
  // Whether the collision is one with a surface, by chance.
  std::optional<Surface> surfaceAt(const glm::vec3& place, const glm::vec3& direction,
                                   const glm::vec3& albedo, PathRandom& random) const {
    if (!(m_terms.surface > 0.0f))
      return std::nullopt;
    const glm::vec3 gradient = m_medium.gradientAt(place);
    const float modulus = glm::length(gradient);
    const auto r =
        static_cast<float>(afterCurve(m_terms.curve, std::min(modulus * m_terms.perReference, 1.0f)));
    const float chance = m_terms.surface * static_cast<float>(significanceWeight(0.05, 0.25, r));
    if (!(random.next() < chance))
      return std::nullopt;
    glm::vec3 normal = modulus > m_terms.flatModulus ? -gradient / modulus : glm::vec3(0.0f);
    if (m_terms.isCut)
      normal =
          normalNearCut(m_terms.cutLower, m_terms.cutUpper, m_terms.spacing, 1.0f, place, direction, normal);
    const float facing = glm::dot(normal, direction);
    if (normal == glm::vec3(0.0f) || facing == 0.0f)
      return std::nullopt;
    const float exponent = m_terms.exponentAtFlat + r * (m_terms.exponentAtBoundary - m_terms.exponentAtFlat);
    return Surface{facing > 0.0f ? -normal : normal, albedo, m_terms.specularShare, exponent};
  }

  // Ends paths by chance, and lets those that go on count for them: ones that carry little, and long ones,
  // which otherwise wander through bright, dense tissue for hours. Of n events √(first/n) go on. How many
  // paths leave a volume after n falls as n^(-3/2), so both the work, the sum of n^(-1/2) over those that go
  // on, and the variance, that of n^(-3/2) times their weight squared, grow as log n and no faster.
  static bool goesOn(int events, glm::vec3& weight, PathRandom& random) {
    constexpr float little = 0.5f;
    constexpr int firstOfLong = 64;
    const float most = std::max({weight.r, weight.g, weight.b});
    if (most < little) {
      if (!(random.next() * little < most))
        return false;
      weight *= little / most;
    }
    const bool isPowerOfTwo = (events & (events - 1)) == 0;
    if (events >= firstOfLong && isPowerOfTwo) {
      constexpr float chance = 0.70710678f;
      if (!(random.next() < chance))
        return false;
      weight /= chance;
    }
    return events < mostEvents;
  }

  // So long no path ever is.
  static constexpr int mostEvents = 1 << 30;

  const PathTerms& m_terms;
  Medium<T> m_medium;
  FreeWay<T> m_way;
  const SkyOf& m_sky;
};

} // namespace limn::cpu
