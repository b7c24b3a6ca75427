// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/paths/Medium.h"
#include "cpu/paths/PathTracer.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace limn::test {

/// The same law by the plainest of paths, as a yardstick: one majorant for the whole volume, lights that are
/// met by chance alone, directions drawn by trial. Paths end where they have left little by the same rule.
template <class T>
class PlainPaths {
public:
  explicit PlainPaths(const cpu::PathTerms& terms) : m_terms(terms), m_medium(terms) {
    const glm::ivec3& blocks = terms.majorants.blocks;
    for (std::size_t n = 0; n < static_cast<std::size_t>(blocks.x) * blocks.y * blocks.z; ++n)
      m_majorant = std::max(m_majorant, terms.majorants.ofBlocks[n]);
  }

  /// Absent where the path meets nothing.
  std::optional<glm::vec3> radiance(const cpu::PathStart& start, cpu::PathRandom& random) const {
    const glm::vec3 key = m_terms.isHeadlight ? -start.direction : m_terms.towardsKey;
    glm::vec3 place = start.place, direction = start.direction, weight(1.0f);
    if (!fly(place, direction, random))
      return std::nullopt;
    for (int events = 0; events < 100'000; ++events) {
      const glm::vec3 albedo = m_medium.albedoAt(place);
      const glm::vec3 before = direction;
      if (const auto surface = surfaceAt(place, before, albedo, random)) {
        direction = onSphere(random);
        // Evenly drawn from a half sphere.
        if (glm::dot(direction, surface->normal) < 0.0f)
          direction = -direction;
        weight *= 2.0f * std::numbers::pi_v<float> * surface->reflected(-before, direction);
      } else {
        direction = onSphere(random);
        weight *= albedo * 4.0f * std::numbers::pi_v<float> *
                  cpu::phase(m_terms.anisotropy, glm::dot(before, direction));
      }
      const float most = std::max({weight.r, weight.g, weight.b});
      if (most < 0.25f) {
        if (!(random.next() * 0.25f < most))
          return glm::vec3(0.0f);
        weight *= 0.25f / most;
      }
      if (!fly(place, direction, random))
        return weight * lightFrom(direction, key);
    }
    return glm::vec3(0.0f);
  }

private:
  glm::vec3 onSphere(cpu::PathRandom& random) const {
    while (true) {
      const glm::vec3 inCube(2.0f * random.next() - 1.0f, 2.0f * random.next() - 1.0f,
                             2.0f * random.next() - 1.0f);
      const float size = glm::length(inCube);
      if (size <= 1.0f && size > 0.01f)
        return inCube / size;
    }
  }

  bool fly(glm::vec3& place, const glm::vec3& direction, cpu::PathRandom& random) const {
    const glm::vec3 perLength = direction * m_terms.perLength;
    while (true) {
      place -= perLength * (std::log(1.0f - random.next()) / m_majorant);
      if (glm::any(glm::lessThan(place, m_terms.lower)) || glm::any(glm::greaterThan(place, m_terms.upper)))
        return false;
      if (random.next() * m_majorant < m_medium.extinctionAt(place))
        return true;
    }
  }

  // Without faces of a crop, and for linear curves.
  std::optional<cpu::Surface> surfaceAt(const glm::vec3& place, const glm::vec3& direction,
                                        const glm::vec3& albedo, cpu::PathRandom& random) const {
    const glm::vec3 gradient = m_medium.gradientAt(place);
    const float modulus = glm::length(gradient);
    const float r = std::min(1.0f, modulus * m_terms.perReference);
    const float x = std::clamp((r - 0.05f) / 0.2f, 0.0f, 1.0f);
    if (!(random.next() < m_terms.surface * x * x * (3.0f - 2.0f * x)))
      return std::nullopt;
    const glm::vec3 normal = gradient / modulus;
    return cpu::Surface{glm::dot(normal, direction) > 0.0f ? -normal : normal, albedo, m_terms.specularShare,
                        m_terms.exponentAtFlat + r * (m_terms.exponentAtBoundary - m_terms.exponentAtFlat)};
  }

  glm::vec3 lightFrom(const glm::vec3& direction, const glm::vec3& key) const {
    float light = cpu::LinearSky{m_terms}(direction);
    if (glm::dot(direction, key) >= m_terms.keyCosine)
      light += m_terms.keyFluence / (2.0f * std::numbers::pi_v<float> * (1.0f - m_terms.keyCosine));
    return glm::vec3(light);
  }

  const cpu::PathTerms& m_terms;
  cpu::Medium<T> m_medium;
  float m_majorant = 0.0f;
};

} // namespace limn::test
