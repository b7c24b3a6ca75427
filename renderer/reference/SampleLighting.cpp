// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/SampleLighting.h"

#include "scene/basics/StableMath.h"

namespace limn {
namespace {

double highlight(const LightingTerms& terms, const RayLight& light, glm::dvec3 normal, double ratio) {
  const double exponent = mapped(ratio, terms.exponent.atFlat, terms.exponent.atBoundary);
  double term = 0.0;
  if (terms.reflection == Reflection::phong) {
    // Mirror the light's direction at the normal and compare it with the viewer's.
    double towardsLight = glm::dot(normal, light.toLight);
    if (terms.twoSided && towardsLight < 0.0) {
      normal = -normal;
      towardsLight = -towardsLight;
    }
    const glm::dvec3 mirrored = 2.0 * towardsLight * normal - light.toLight;
    term = towardsLight > 0.0 ? blinnTerm(glm::dot(mirrored, light.toViewer), exponent) : 0.0;
  } else {
    const double alignment = glm::dot(normal, light.halfway);
    term = blinnTerm(terms.twoSided ? std::abs(alignment) : alignment, exponent);
  }
  if (terms.energyFactor)
    term *= energyFactor(exponent, terms.exponent.atBoundary);
  if (terms.significance)
    term *= significanceWeight(terms.significance->low, terms.significance->high, ratio);
  return term;
}

} // namespace

RayLight lightAlong(const glm::dvec3& direction, const std::optional<glm::dvec3>& towardsLight) {
  RayLight light;
  light.toViewer = -direction;
  light.toLight = light.toViewer;
  light.halfway = light.toViewer;
  if (towardsLight) {
    light.toLight = *towardsLight;
    const glm::dvec4 halfway = safeNormal(light.toLight + light.toViewer);
    light.halfway = halfway.w > shortestHalfVector ? glm::dvec3(halfway) : glm::dvec3(0.0);
  }
  return light;
}

glm::dvec3 lit(const LightingTerms& terms, const glm::dvec3& material, const RayLight& light,
               const glm::dvec3& normal, double ratio, const Reaching& reaching) {
  if (!terms.isLit)
    return material;
  glm::dvec3 sum = material * (terms.ambient * reaching.ambient);
  if (terms.diffuse != 0.0) {
    const double facing = glm::dot(normal, light.toLight);
    sum += material *
           (reaching.direct * terms.diffuse * std::max(0.0, terms.twoSided ? std::abs(facing) : facing));
  }
  if (terms.specular != 0.0) {
    const double term = reaching.direct * terms.specular * highlight(terms, light, normal, ratio);
    sum += terms.specularColor == SpecularColor::light ? glm::dvec3(term) : material * term;
  }
  if (terms.isUnlimited)
    return sum;
  return glm::clamp(terms.knee ? knee(sum, *terms.knee) : sum, 0.0, 1.0);
}

double fogFactor(const Fog& fog, double z) {
  switch (fog.mode) {
  case Fog::Mode::none:
    return 1.0;
  case Fog::Mode::linear:
    return fogLinear(z, fog.startMm, fog.endMm);
  case Fog::Mode::exp:
    return fogExp(z, fog.startMm, fog.densityPerMm);
  case Fog::Mode::exp2:
    return fogExp2(z, fog.startMm, fog.densityPerMm);
  }
  return 1.0;
}

} // namespace limn
