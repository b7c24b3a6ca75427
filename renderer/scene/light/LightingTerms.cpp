// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/LightingTerms.h"

#include "scene/basics/StableMath.h"
#include "scene/light/Boundary.h"
#include "scene/light/Gradient.h"
#include "scene/view/Camera.h"

#include <algorithm>

namespace limn {
namespace {

// What no term of the sum uses goes back to its neutral value, so that equal pictures have equal terms.
LightingTerms withoutUnused(LightingTerms terms) {
  if (terms.specular == 0.0) {
    terms.exponent = {1.0, 1.0};
    terms.significance.reset();
    terms.reflection = Reflection::blinn;
    terms.specularColor = SpecularColor::material;
  }
  if (!terms.reflects()) {
    terms.twoSided = false;
    terms.lightDirection.reset();
  }
  if (!terms.lightDirection)
    terms.lightAxes = LightAxes::world;
  if (!terms.lightDirection || !(terms.shadow.strength > 0.0))
    terms.shadow = {};
  if (terms.ambient == 0.0 || !(terms.occlusion.strength > 0.0))
    terms.occlusion = {};
  if (terms.exponent.atFlat == terms.exponent.atBoundary)
    terms.energyFactor = false;
  const bool isGammaOne = terms.curve.type == GradientCurve::Type::gamma && terms.curve.parameter == 1.0;
  if (isGammaOne || terms.curve.type == GradientCurve::Type::linear || !terms.usesRatio())
    terms.curve = {};
  // The sum cannot pass the knee: each colour channel is at most 1.
  if (terms.knee && terms.ambient + terms.diffuse + terms.specular <= *terms.knee)
    terms.knee.reset();
  return terms;
}

std::optional<glm::dvec3> inWorld(const std::optional<glm::dvec3>& direction, LightAxes axes,
                                  const Camera& camera) {
  if (!direction || axes == LightAxes::world)
    return direction;
  const CameraBasis basis = basisOf(camera);
  return direction->x * basis.right + direction->y * basis.up + direction->z * basis.forward;
}

// The weight of a term. One so large drives every channel that is not 0 to full brightness; an infinite one
// would make no number of a 0.
double limitedProduct(double coefficient, double intensity) {
  return std::min(coefficient * intensity, 1e30);
}

} // namespace

LightingTerms lightingTerms(const Shading& shading) {
  LightingTerms terms;
  if (shading.model == ShadingModel::none || shading.model == ShadingModel::physical)
    return terms;
  terms.isLit = true;
  terms.ambient = limitedProduct(shading.ambient, shading.ambientIntensity);
  terms.diffuse = limitedProduct(shading.diffuse, shading.lightIntensity);
  terms.specular = limitedProduct(shading.specular, shading.lightIntensity);
  terms.exponent = {shading.exponent, shading.exponent};
  terms.specularColor = shading.specularColor;
  terms.reflection = shading.reflection;
  terms.twoSided = shading.twoSided;
  terms.lightDirection = shading.lightDirection;
  terms.lightAxes = shading.lightAxes;
  terms.shadow = shading.shadow;
  terms.occlusion = shading.occlusion;
  if (shading.model != ShadingModel::classic) {
    terms.exponent = shading.exponentRange;
    terms.opacity = shading.opacityRange;
    terms.curve = shading.gradientCurve;
  }
  if (shading.model == ShadingModel::robust) {
    terms.energyFactor = shading.energyFactor;
    terms.significance = shading.significance;
    terms.knee = shading.knee;
  }
  return withoutUnused(terms);
}

std::optional<glm::dvec3> lightTravels(const LightingTerms& terms, const Camera& camera) {
  return inWorld(terms.lightDirection, terms.lightAxes, camera);
}

std::optional<glm::dvec3> lightTravels(const Shading& shading, const Camera& camera) {
  return inWorld(shading.lightDirection, shading.lightAxes, camera);
}

double gradientRatio(const LightingTerms& terms, const GradientScale& scale, double modulus) {
  const double r = scale.reference > 0.0 ? std::clamp(modulus / scale.reference, 0.0, 1.0) : 0.0;
  return afterCurve(terms.curve, r);
}

double gradientOpacityAt(const GradientOpacity& curve, double modulus) {
  const auto& points = curve.points;
  if (points.empty())
    return 1.0;
  const auto right = std::upper_bound(
      points.begin(), points.end(), modulus,
      [](double value, const GradientOpacityPoint& point) { return value < point.gradient; });
  if (right == points.begin())
    return right->opacity;
  const auto left = right - 1;
  if (right == points.end())
    return left->opacity;
  const double w = (modulus - left->gradient) / (right->gradient - left->gradient);
  return glm::mix(left->opacity, right->opacity, w);
}

} // namespace limn
