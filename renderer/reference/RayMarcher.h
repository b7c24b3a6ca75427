// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/FieldSampler.h"
#include "reference/LocalMarch.h"
#include "reference/SampleLighting.h"
#include "scene/basics/StableMath.h"
#include "scene/effects/EffectPlan.h"
#include "scene/function/MeanMaterial.h"

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

/// One ray of a picture in equal steps, a sample `offset` steps behind the start of each (DEFINITION section
/// 7). Places along it are in steps from the entry.
template <class T>
class RayMarcher {
public:
  RayMarcher(const PictureTerms& terms, const FieldSampler<T>& field, const FramedRay& ray,
             const RaySpan& span, double offset)
      : m_terms(terms), m_field(field), m_ray(ray), m_span(span), m_offset(offset),
        m_light(lightAlong(ray.direction * terms.grid.spacingMm, terms.towardsLight)) {
    divide();
  }

  /// Of equal steps as many as the span has, of error-controlled ones those that `pixel` took.
  int samples() const { return m_count; }

  /// Premultiplied colour and alpha of the scene's projection.
  glm::dvec4 pixel() {
    switch (m_terms.scene.projection) {
    case Projection::composite:
      return composite();
    case Projection::compositeIsosurface:
      return compositeOverSurface();
    case Projection::isosurface:
      return surface();
    case Projection::xray:
      return xray();
    case Projection::mip:
    case Projection::minip:
    case Projection::average:
      return classifiedOnce();
    }
    return glm::dvec4(0.0);
  }

private:
  // What one step absorbs: its opacity and extinction over the unit distance, and its colour.
  struct Material {
    double opacity = 0.0;
    double extinction = 0.0;
    glm::dvec3 color{0.0};
  };

  // What a sample says of the piece for which it stands.
  struct Piece {
    double extinction = 0.0; // over the unit distance
    glm::dvec3 color{0.0};
    bool operator==(const Piece&) const = default;
  };

  void divide() {
    m_count = sampleCount(m_span.end - m_span.begin, m_terms.step, m_terms.mostSamples);
    m_dt = (m_span.end - m_span.begin) / m_count;
  }

  double tAt(double place) const { return m_span.begin + place * m_dt; }
  glm::dvec3 centredAt(double place) const { return m_ray.anchor + tAt(place) * m_ray.direction; }
  Cell cellAt(double place) const { return m_field.cellAt(centredAt(place) + m_terms.centre); }
  double scalarAt(double place) const { return m_field.scalarAt(cellAt(place)); }

  // What the kept region leaves of the opacity.
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

  // The colour of a material at a place, lit and fogged.
  glm::dvec3 shaded(const glm::dvec3& material, double place, const glm::dvec4& gradient,
                    double ratio) const {
    const LightingTerms& terms = m_terms.terms;
    const double flat = std::ldexp(m_terms.scale.largest, -20);
    glm::dvec3 normal = gradient.w > flat ? -glm::dvec3(gradient) : glm::dvec3(0.0);
    if (m_terms.isCut && terms.usesNormal())
      normal = normalNearCut(m_terms.cut, m_terms.grid.spacingMm, m_terms.smallestMm, centredAt(place),
                             m_ray.direction, normal);
    const glm::dvec3 color = lit(terms, material, m_light, normal, ratio);
    const double f = fogFactor(m_terms.scene.fog, tAt(place) - m_ray.eye);
    return f * color + (1.0 - f) * m_terms.scene.fog.color;
  }

  // The unit gradient with its modulus, and r, where anything reads them.
  glm::dvec4 gradientAt(double place, double& ratio) const {
    ratio = 0.0;
    if (!m_terms.readsGradient)
      return glm::dvec4(0.0);
    const glm::dvec4 gradient = safeNormal(m_field.gradientAt(cellAt(place)));
    ratio = gradientRatio(m_terms.terms, m_terms.scale, gradient.w);
    return gradient;
  }

  Piece pieceAt(double place, const Material& material) const {
    double ratio = 0.0;
    const glm::dvec4 gradient = gradientAt(place, ratio);

    // Change the opacity before it becomes an extinction, so that the picture does not depend on the step.
    double extinction = material.extinction;
    if (m_terms.changesOpacity) {
      const CoefficientRange& o = m_terms.terms.opacity;
      double opacity = material.opacity * mapped(ratio, o.atFlat, o.atBoundary);
      if (m_terms.hasGradientOpacity)
        opacity *= gradientOpacityAt(*m_terms.scene.gradientOpacity, gradient.w);
      opacity *= weightAt(place);
      extinction = minusLog1mOpacity(opacity);
    }
    return {extinction, shaded(material.color, place, gradient, ratio)};
  }

  double alphaOf(const Piece& piece, double lengthMm) const {
    return oneMinusExpNeg(piece.extinction * lengthMm / m_terms.scene.transferFunction.unitDistanceMm);
  }

  // Composites front to back: adds a piece to the colour (rgb) and takes its share from the transmittance
  // (a).
  void add(const Piece& piece, double lengthMm, glm::dvec4& sum) const {
    const double weight = sum.a * alphaOf(piece, lengthMm);
    sum = glm::dvec4(glm::dvec3(sum) + weight * piece.color, sum.a - weight);
  }

  // Takes error-controlled steps, whose places are in mm; `pieceAt` says what lies at one, and whether the
  // ray ends is asked behind each. The sum is that of `composite`.
  template <class PieceOf, class IsEnd>
  glm::dvec4 marchedLocally(const PieceOf& pieceOf, const IsEnd& isEnd) {
    m_offset = 0.0;
    m_dt = 1.0;
    glm::dvec4 sum(0.0, 0.0, 0.0, 1.0);
    const auto sample = [&](double place) {
      const Material material = materialAt(place);
      return material.opacity > 0.0 ? pieceOf(place, material) : Piece{};
    };
    const auto change = [&](const Piece& before, const Piece& here, double halfMm) {
      const double was = alphaOf(before, halfMm);
      const double is = alphaOf(here, halfMm);
      const glm::dvec3 color = glm::abs(is * here.color - was * before.color);
      return 2.0 * sum.a * std::max({color.r, color.g, color.b, std::abs(is - was)});
    };
    const auto addPiece = [&](const Piece& piece, double lengthMm) {
      add(piece, lengthMm, sum);
      return sum.a;
    };
    // Who may take more equal samples than a driver can may do so here.
    const int most = m_terms.mostSamples > mostSamples ? m_terms.mostSamples : mostLocalSamples;
    m_count = marchLocally<Piece>(
        *m_terms.local, BlockWalk(*m_terms.local, m_ray, m_span), sample, change, addPiece,
        [&] { return isEnd(sum); }, most);
    return sum;
  }

  glm::dvec4 composite() {
    const bool endsEarly = m_terms.scene.quality.earlyTermination < 1.0;
    const double last = lastTransmittance(m_terms.scene.quality.earlyTermination);
    const auto isEnd = [&](const glm::dvec4& sum) {
      return (endsEarly && sum.a <= last) || sum.a < nothingLeft;
    };
    if (m_terms.local) {
      const glm::dvec4 sum = marchedLocally(
          [&](double place, const Material& material) { return pieceAt(place, material); }, isEnd);
      return {glm::dvec3(sum), 1.0 - sum.a};
    }
    glm::dvec4 sum(0.0, 0.0, 0.0, 1.0);
    for (int i = 0; i < m_count; ++i) {
      const Material material = materialAt(i + m_offset);
      if (!(material.opacity > 0.0))
        continue;
      add(pieceAt(i + m_offset, material), m_dt, sum);
      if (isEnd(sum))
        break;
    }
    return {glm::dvec3(sum), 1.0 - sum.a};
  }

  // Where the field first reaches the isovalue in what is kept; absent where it stays below.
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

  glm::dvec3 surfaceColor(double place) const {
    double ratio = 0.0;
    const glm::dvec4 gradient = gradientAt(place, ratio);
    const Classified classified = classify(m_terms.scene.transferFunction, m_terms.scene.isovalue);
    return shaded(classified.color, place, gradient, ratio);
  }

  glm::dvec4 surface() const {
    const std::optional<double> hit = firstHit();
    return hit ? glm::dvec4(surfaceColor(*hit), 1.0) : glm::dvec4(0.0);
  }

  glm::dvec4 compositeOverSurface() {
    const std::optional<double> hit = firstHit();
    if (!hit)
      return composite();
    // Gather what lies before the surface in steps of its own, then put it over the surface.
    const glm::dvec3 behind = surfaceColor(*hit);
    m_span.end = tAt(*hit);
    if (!(m_span.end > m_span.begin))
      return {behind, 1.0};
    divide();
    const glm::dvec4 before = composite();
    return {glm::dvec3(before) + (1.0 - before.a) * behind, 1.0};
  }

  glm::dvec4 xray() {
    if (m_terms.local) {
      const glm::dvec4 sum = marchedLocally(
          [this](double place, const Material& material) {
            return Piece{absorptionAt(place, material), glm::dvec3(0.0)};
          },
          [](const glm::dvec4&) { return false; });
      return glm::dvec4(1.0 - sum.a);
    }
    double depth = 0.0;
    for (int i = 0; i < m_count; ++i)
      depth += absorptionAt(i + m_offset, materialAt(i + m_offset));
    return glm::dvec4(oneMinusExpNeg(depth * m_dt / m_terms.scene.transferFunction.unitDistanceMm));
  }

  // The extinction of an X-ray, which knows no other factor of the opacity.
  double absorptionAt(double place, const Material& material) const {
    const double weight = weightAt(place);
    return weight == 1.0 ? material.extinction : minusLog1mOpacity(weight * material.opacity);
  }

  // The largest, smallest or mean scalar of the samples that are kept, classified once.
  glm::dvec4 classifiedOnce() const {
    const Projection projection = m_terms.scene.projection;
    int kept = 0;
    double scalar = 0.0;
    for (int i = 0; i < m_count; ++i) {
      if (!isKept(i + m_offset))
        continue;
      const double next = scalarAt(i + m_offset);
      scalar = kept++ == 0                       ? next
               : projection == Projection::mip   ? std::max(scalar, next)
               : projection == Projection::minip ? std::min(scalar, next)
                                                 : scalar + next;
    }
    if (kept == 0)
      return glm::dvec4(0.0);
    if (projection == Projection::average)
      scalar /= kept;
    const Classified classified = classify(m_terms.scene.transferFunction, scalar);
    return {classified.opacity * classified.color, classified.opacity};
  }

  static constexpr int halvings = 14; // to less than 1e-4 of a step

  // Light through so little cannot change the last digit of 1 in double precision, however bright.
  static constexpr double nothingLeft = 1e-20;

  const PictureTerms& m_terms;
  const FieldSampler<T>& m_field;
  FramedRay m_ray;
  RaySpan m_span;
  double m_offset;
  RayLight m_light;
  int m_count = 1;
  double m_dt = 0.0;
};

} // namespace limn
