// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Shading.h"

namespace limn {

struct Camera;
struct GradientScale;

/// The numbers of the lighting model with the differences between the four models resolved: what a model does
/// not use has its neutral value. Two shadings with equal terms give the same picture.
struct LightingTerms {
  bool isLit = false;
  double ambient = 1.0;                ///< ka·Ia
  double diffuse = 0.0;                ///< kd·Id
  double specular = 0.0;               ///< ks·Id
  CoefficientRange exponent{1.0, 1.0}; ///< SPmin, SPmax
  CoefficientRange opacity{1.0, 1.0};  ///< Omin, Omax
  GradientCurve curve;                 ///< linear where nothing uses r
  bool energyFactor = false;           ///< false where SPmin = SPmax: the factor is 1
  std::optional<Significance> significance;
  std::optional<double> knee; ///< absent: clamp to [0,1] only
  bool isUnlimited = false;   ///< the sum is not limited: to measure how far it overflows
  SpecularColor specularColor = SpecularColor::material;
  Reflection reflection = Reflection::blinn;
  bool twoSided = false;
  std::optional<glm::dvec3> lightDirection;
  LightAxes lightAxes = LightAxes::world;
  Shadow shadow;       ///< neutral where no light has a direction or nothing reflects it
  Occlusion occlusion; ///< neutral where there is no ambient light

  bool operator==(const LightingTerms&) const = default;

  bool mapsExponent() const { return specular != 0.0 && exponent.atFlat != exponent.atBoundary; }
  bool mapsOpacity() const { return opacity.atFlat != opacity.atBoundary; }

  /// Whether light that has a direction shows.
  bool reflects() const { return diffuse != 0.0 || specular != 0.0; }

  /// Whether any term asks for the normal, for r, or for either.
  bool usesNormal() const { return reflects() || occlusion.strength > 0.0; }
  bool usesRatio() const { return mapsExponent() || mapsOpacity() || significance.has_value(); }
};

/// The terms of any of the four models that light samples; those of none for physical light, which lights
/// none.
LightingTerms lightingTerms(const Shading& shading);

/// The direction in which the light travels, world; absent: headlight.
std::optional<glm::dvec3> lightTravels(const LightingTerms& terms, const Camera& camera);
std::optional<glm::dvec3> lightTravels(const Shading& shading, const Camera& camera);

/// The normalised gradient modulus r after its curve (DEFINITION section 2).
double gradientRatio(const LightingTerms& terms, const GradientScale& scale, double modulus);

/// The gradient-opacity curve G at a modulus, value/mm; 1 without points.
double gradientOpacityAt(const GradientOpacity& curve, double modulus);

} // namespace limn
