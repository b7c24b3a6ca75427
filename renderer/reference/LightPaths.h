// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/RaySamples.h"
#include "scene/ProjectionFacts.h"
#include "scene/light/LightDirections.h"

#include <algorithm>
#include <cmath>

namespace limn {

/// The terms of the paths along which light comes in a picture: steps of a quarter of a voxel at most.
inline PictureTerms lightPathTerms(const PictureTerms& ofPicture) {
  PictureTerms terms = ofPicture;
  terms.step = std::min(terms.step, 0.25 * terms.smallestMm);
  return terms;
}

/// How much light comes to places of a picture's volume past what stands in its way (DEFINITION section 11):
/// M, in twice and twice as many directions until two changes on end are less than a thousandth.
template <class T>
class LightPaths {
public:
  /// `terms` are those of light paths.
  LightPaths(const PictureTerms& terms, const FieldSampler<T>& field)
      : m_terms(terms), m_field(field), m_offsetMm(lightOffsetMm(terms.grid)) {}

  /// Of a light that has a direction.
  double ofLight(const glm::dvec3& centredIndex) const {
    const glm::dvec3& axis = *m_terms.towardsLight;
    const double angle = m_terms.terms.shadow.softnessDeg;
    if (angle == 0.0)
      return transmittance(centredIndex, axis, 1e300);
    const glm::dmat3 axes = axesAround(axis);
    return meanOver([&](const glm::dvec2& point) {
      return transmittance(centredIndex, axes * directionInCone(point, angle), 1e300);
    });
  }

  /// Of ambient light, around a normal along the grid's axes, of unit length or zero.
  double ofSurroundings(const glm::dvec3& centredIndex, const glm::dvec3& normal) const {
    const double reach = m_terms.terms.occlusion.reachMm;
    if (normal == glm::dvec3(0.0))
      return meanOver([&](const glm::dvec2& point) {
        return transmittance(centredIndex, directionOnSphere(point), reach);
      });
    const glm::dmat3 axes = axesAround(normal);
    return meanOver([&](const glm::dvec2& point) {
      return transmittance(centredIndex, axes * directionByCosine(point), reach);
    });
  }

private:
  static constexpr int fewestDirections = 32;
  static constexpr int mostDirections = 1 << 14;
  static constexpr double standsStill = 1e-3;

  template <class Of>
  static double meanOver(const Of& of) {
    double sum = 0.0;
    int count = 0;
    const auto upTo = [&](int directions) {
      for (; count < directions; ++count)
        sum += of(spreadPoint(count));
      return sum / directions;
    };
    double mean = upTo(fewestDirections);
    // Sums may agree by chance; three hardly do.
    for (int still = 0; still < 2 && count < mostDirections;) {
      const double before = mean;
      mean = upTo(2 * count);
      still = std::abs(mean - before) < standsStill ? still + 1 : 0;
    }
    return mean;
  }

  // exp(-τ) from a place on, as far as `reachMm`; 0 where a surface that is shown stands in the way.
  double transmittance(const glm::dvec3& from, const glm::dvec3& direction, double reachMm) const {
    const FramedRay ray{from, direction / m_terms.grid.spacingMm, m_offsetMm};
    RaySpan span = spanInBox(ray, m_terms.box);
    span.end = std::min(span.end, reachMm);
    if (span.isEmpty())
      return 1.0;
    const RaySamples<T> samples(m_terms, m_field, ray, span, 0.5);
    const Projection projection = m_terms.scene.projection;
    if (showsSurface(projection) && samples.firstHit())
      return 0.0;
    if (projection == Projection::isosurface) // nothing but the surface is there
      return 1.0;
    double depth = 0.0;
    for (int i = 0; i < samples.count() && depth < nothingLeft; ++i) {
      const double place = i + samples.offset();
      const typename RaySamples<T>::Material material = samples.materialAt(place);
      if (material.opacity > 0.0)
        depth += samples.absorbedAt(place, material, samples.steepnessAt(place)).extinction *
                 samples.stepMm() / m_terms.unitMm;
    }
    return std::exp(-depth);
  }

  // Of light that has passed so much a millionth is left.
  static constexpr double nothingLeft = 14.0;

  const PictureTerms& m_terms;
  const FieldSampler<T>& m_field;
  double m_offsetMm;
};

} // namespace limn
