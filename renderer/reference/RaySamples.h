// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/FieldSampler.h"
#include "scene/basics/StableMath.h"
#include "scene/effects/EffectPlan.h"
#include "scene/function/MeanMaterial.h"
#include "scene/light/Gradient.h"
#include "scene/light/LightingTerms.h"
#include "scene/steps/BlockWalk.h"
#include "scene/steps/RayFrame.h"

namespace limn {

/// What every ray of a picture shares.
struct PictureTerms {
  const Scene& scene;
  EffectSet effects; ///< that the scene calls for; decides on the steps only
  LightingTerms terms = lightingTerms(scene.shading);
  const Grid& grid = scene.volume->grid();
  IndexBox box = croppedBox(grid, scene.crop);
  CutPlanes cut = cutPlanes(grid, scene.crop);
  bool isCut = scene.crop != CropBox{};
  double step = stepMm(scene);
  int mostSamples = limn::mostSamples; ///< of one ray
  double smallestMm = smallestSpacingMm(grid);
  glm::dvec3 centre = centreIndex(grid);
  std::optional<glm::dvec3> towardsLight =
      terms.lightDirection ? std::optional(towardsLightAlongAxes(*terms.lightDirection, grid)) : std::nullopt;
  bool hasGradientOpacity = scene.gradientOpacity && !scene.gradientOpacity->points.empty();
  bool hasRegion = isRestricting(scene.keep);
  bool changesOpacity = hasRegion || hasGradientOpacity || terms.mapsOpacity() || terms.opacity.atFlat != 1.0;
  bool readsGradient = terms.usesNormal() || terms.usesRatio() || hasGradientOpacity;
  std::optional<LocalStepTerms> local =
      effects.has(Effect::localSteps) ? localStepTerms(scene) : std::nullopt;
  GradientScale scale = readsGradient ? gradientScale(*scene.volume, scene.shading) : GradientScale{};
};

/// What a ray meets in equal steps, a sample `offset` steps behind the start of each (DEFINITION section 7).
/// Places along it are in steps from the entry.
template <class T>
class RaySamples {
public:
  /// What one step absorbs: its opacity and extinction over the unit distance, and its colour.
  struct Material {
    double opacity = 0.0;
    double extinction = 0.0;
    glm::dvec3 color{0.0};
  };

  /// The unit gradient with its modulus, and r; 0 where nothing reads them.
  struct Steepness {
    glm::dvec4 gradient{0.0};
    double ratio = 0.0;
  };

  RaySamples(const PictureTerms& terms, const FieldSampler<T>& field, const FramedRay& ray,
             const RaySpan& span, double offset)
      : m_terms(terms), m_field(field), m_ray(ray), m_offset(offset) {
    divide(span);
  }

  /// From now on of another part of the ray.
  void divide(const RaySpan& span) {
    m_span = span;
    m_count = sampleCount(span.end - span.begin, m_terms.step, m_terms.mostSamples);
    m_dt = (span.end - span.begin) / m_count;
  }

  /// From now on places are in mm from the entry, for steps that are not equal.
  void countInMm() {
    m_offset = 0.0;
    m_dt = 1.0;
  }

  int count() const { return m_count; }
  double offset() const { return m_offset; }
  double stepMm() const { return m_dt; }
  const RaySpan& span() const { return m_span; }
  const FramedRay& ray() const { return m_ray; }

  double tAt(double place) const { return m_span.begin + place * m_dt; }
  glm::dvec3 centredAt(double place) const { return m_ray.anchor + tAt(place) * m_ray.direction; }
  double scalarAt(double place) const { return m_field.scalarAt(cellAt(place)); }

  /// What the kept region leaves of the opacity.
  double weightAt(double place) const {
    return m_terms.hasRegion ? limn::weightAt(m_terms.scene.keep, centredAt(place) + m_terms.centre) : 1.0;
  }
  bool isKept(double place) const { return weightAt(place) >= 0.5; }

  Material materialAt(double place) const {
    if (m_terms.effects.has(Effect::preintegration)) {
      const MeanMaterial mean = meanMaterial(m_terms.scene.transferFunction, scalarAt(place - m_offset),
                                             scalarAt(place + 1.0 - m_offset));
      return {oneMinusExpNeg(mean.extinction), mean.extinction, mean.color};
    }
    const Classified classified = classify(m_terms.scene.transferFunction, scalarAt(place));
    return {classified.opacity, minusLog1mOpacity(classified.opacity), classified.color};
  }

  Steepness steepnessAt(double place) const {
    if (!m_terms.readsGradient)
      return {};
    const glm::dvec4 gradient = safeNormal(m_field.gradientAt(cellAt(place)));
    return {gradient, gradientRatio(m_terms.terms, m_terms.scale, gradient.w)};
  }

  /// The extinction of a material there, over the unit distance.
  double extinctionAt(double place, const Material& material, const Steepness& steepness) const {
    if (!m_terms.changesOpacity)
      return material.extinction;
    // Change the opacity before it becomes an extinction, so that the picture does not depend on the step.
    const CoefficientRange& o = m_terms.terms.opacity;
    double opacity = material.opacity * mapped(steepness.ratio, o.atFlat, o.atBoundary);
    if (m_terms.hasGradientOpacity)
      opacity *= gradientOpacityAt(*m_terms.scene.gradientOpacity, steepness.gradient.w);
    return minusLog1mOpacity(opacity * weightAt(place));
  }

  /// The extinction of an X-ray, which knows no other factor of the opacity.
  double absorptionAt(double place, const Material& material) const {
    const double weight = weightAt(place);
    return weight == 1.0 ? material.extinction : minusLog1mOpacity(weight * material.opacity);
  }

  /// What a length of this extinction absorbs, 0..1.
  double alphaOf(double extinction, double lengthMm) const {
    return oneMinusExpNeg(extinction * lengthMm / m_terms.scene.transferFunction.unitDistanceMm);
  }

  /// Where the field first reaches the isovalue in what is kept; absent where it stays below.
  std::optional<double> firstHit() const {
    const auto isHitAt = [this](double place) {
      return scalarAt(place) >= m_terms.scene.isovalue && isKept(place);
    };
    const double exit = m_count;
    double below = 0.0;
    if (isHitAt(below))
      return below;

    // Find the first sample at or above the isovalue; the exit counts as the last one.
    std::optional<double> above;
    for (int i = 0; i <= m_count && !above; ++i) {
      const double place = std::min(i + m_offset, exit);
      (isHitAt(place) ? above.emplace() : below) = place;
    }
    if (!above)
      return std::nullopt;

    // Halve the bracket.
    for (int k = 0; k < halvings; ++k) {
      const double middle = 0.5 * (below + *above);
      (isHitAt(middle) ? *above : below) = middle;
    }
    return above;
  }

private:
  Cell cellAt(double place) const { return m_field.cellAt(centredAt(place) + m_terms.centre); }

  static constexpr int halvings = 14; // to less than 1e-4 of a step

  const PictureTerms& m_terms;
  const FieldSampler<T>& m_field;
  FramedRay m_ray;
  RaySpan m_span;
  double m_offset;
  int m_count = 1;
  double m_dt = 0.0;
};

} // namespace limn
