// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/PhysicalLight.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <variant>
#include <vector>

namespace limn {

/// How a sample is lit (DEFINITION sections 4 and 5): `none` is unlit, `classic` Blinn-Phong, `enhanced` the
/// paper's model literally, `robust` our answer to its overflowing highlights. With `physical` no sample is
/// lit: light goes random ways through what the curve makes of the volume (section 12).
enum class ShadingModel { none, classic, enhanced, robust, physical };

/// The gradient modulus that maps to r = 1.
struct AutomaticReference { ///< largest modulus for enhanced, 99.5th percentile for robust
  bool operator==(const AutomaticReference&) const = default;
};
struct LargestReference {
  bool operator==(const LargestReference&) const = default;
};
struct PercentileReference {
  double percent = 99.5; ///< 0..100, nearest rank
  bool operator==(const PercentileReference&) const = default;
};
struct FixedReference {
  double valuePerMm = 1.0; ///< > 0
  bool operator==(const FixedReference&) const = default;
};
using GradientReference =
    std::variant<AutomaticReference, LargestReference, PercentileReference, FixedReference>;

/// The curve applied to the normalised gradient modulus: linear, r^gamma, or log1p(b r)/log1p(b).
struct GradientCurve {
  enum class Type { linear, gamma, log };
  Type type = Type::linear;
  double parameter = 1.0; ///< gamma or b, > 0; unused when linear
  bool operator==(const GradientCurve&) const = default;
};

/// A closed range mapped from r = 0 to r = 1.
struct CoefficientRange {
  double atFlat = 0.0;     ///< where the gradient is 0: SPmin, Omin
  double atBoundary = 1.0; ///< where the gradient reaches its reference: SPmax, Omax
  bool operator==(const CoefficientRange&) const = default;
};

/// Rising weight of the specular term, smoothstep between two values of r.
struct Significance {
  double low = 0.05;
  double high = 0.25;
  bool operator==(const Significance&) const = default;
};

/// What the exponent is applied to: the half vector (Blinn) or the reflected ray (Phong). And whose colour a
/// highlight has.
enum class Reflection { blinn, phong };
enum class SpecularColor { material, light };

/// In whose axes the direction of a light is told: the world's, or right, up and forward of the camera, with
/// which the light then turns.
enum class LightAxes { world, camera };

/// How what lies between a place and its light dims diffuse light and highlights (DEFINITION section 11).
struct Shadow {
  double strength = 0.0;    ///< s, 0..1
  double softnessDeg = 4.0; ///< ρ, 0..45: the angular radius of the light
  bool operator==(const Shadow&) const = default;
};

/// How what lies around a place dims its ambient light (DEFINITION section 11).
struct Occlusion {
  double strength = 0.0; ///< o, 0..1
  double reachMm = 20.0; ///< R > 0: what lies farther away does not count
  bool operator==(const Occlusion&) const = default;
};

/// The widest Gaussian by which a field is smoothed before its gradient is taken, mm.
inline constexpr double mostGradientSmoothing = 20.0;

/// Every number of the lighting model. Paper eq. 1–9; DEFINITION sections 4 and 5 hold formulas and limits.
struct Shading {
  ShadingModel model = ShadingModel::classic;
  double ambient = 1.0;                      ///< ka ≥ 0
  double diffuse = 1.0;                      ///< kd ≥ 0
  double specular = 1.0;                     ///< ks ≥ 0
  double ambientIntensity = 0.25;            ///< Ia ≥ 0
  double lightIntensity = 0.75;              ///< Id ≥ 0
  double exponent = 32.0;                    ///< SP of classic, 0 < SP ≤ 1024
  CoefficientRange exponentRange{1.0, 64.0}; ///< SPmin..SPmax of enhanced and robust
  CoefficientRange opacityRange{0.0, 3.0};   ///< Omin..Omax of enhanced and robust, 0..8
  GradientReference gradientReference;
  GradientCurve gradientCurve;
  double gradientSmoothing = 0.0;                           ///< σ, mm, 0..mostGradientSmoothing; 0: none
  bool energyFactor = true;                                 ///< robust: specular × (SP+8)/(SPmax+8)
  std::optional<Significance> significance{Significance{}}; ///< robust; absent: weight 1
  std::optional<double> knee = 0.8;                         ///< robust; absent: clamp to [0,1]
  SpecularColor specularColor = SpecularColor::material;
  Reflection reflection = Reflection::blinn;
  bool twoSided = false;
  std::optional<glm::dvec3> lightDirection; ///< in which the light travels; absent: headlight
  LightAxes lightAxes = LightAxes::world;   ///< of the direction
  Shadow shadow;
  Occlusion occlusion;
  PhysicalLight physical; ///< read by the physical model alone

  bool operator==(const Shading&) const = default;
};

/// One point of the gradient-opacity curve G(|g|).
struct GradientOpacityPoint {
  double gradient = 0.0; ///< value/mm, ≥ 0
  double opacity = 1.0;  ///< 0..1
  bool operator==(const GradientOpacityPoint&) const = default;
};

/// Gradient-dependent opacity (lecture, boundary opacity): piecewise linear, constant outside.
struct GradientOpacity {
  std::vector<GradientOpacityPoint> points;
  bool operator==(const GradientOpacity&) const = default;
};

/// Every shading model, in the order in which they are offered.
inline constexpr std::array shadingModels{ShadingModel::none, ShadingModel::classic, ShadingModel::enhanced,
                                          ShadingModel::robust, ShadingModel::physical};

/// Those whose samples are lit one by one, or not at all: pictures without chance.
inline constexpr std::array localModels{ShadingModel::none, ShadingModel::classic, ShadingModel::enhanced,
                                        ShadingModel::robust};

/// The word for a model in scene files and on the command line.
inline const char* nameOf(ShadingModel model) {
  constexpr std::array names{"none", "classic", "enhanced", "robust", "physical"};
  return names[static_cast<std::size_t>(model)];
}

} // namespace limn
