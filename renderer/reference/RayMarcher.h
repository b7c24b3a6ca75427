// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/CellMarch.h"
#include "reference/CellScalars.h"
#include "reference/LightPaths.h"
#include "reference/RaySamples.h"
#include "reference/SampleLighting.h"
#include "scene/light/Boundary.h"
#include "scene/steps/BlockWalk.h"

namespace limn {

/// Takes the pieces of a ray one after the other, with a sample at either end of each. `sample(place)` gives
/// what lies there, `changeOver(before, here, halfMm)` how much the light that the two halves of a piece add
/// to a channel of the pixel (0..1) differs, as if either were the whole; `add(half, halfMm)` composites one
/// and gives the transmittance behind it; `isEnd()` ends the ray. Behind `most` samples each block gets one.
/// Returns how many samples were taken.
template <class Half, class Sample, class Change, class Add, class IsEnd>
int marchLocally(const LocalStepTerms& terms, BlockWalk walk, const Sample& sample, const Change& changeOver,
                 const Add& add, const IsEnd& isEnd, int most = mostLocalSamples) {
  const double limit = mostChange(terms.fineness);
  int rung = 0;
  double transmittance = 1.0;
  Half before = sample(0.0);
  int spent = before == Half{} ? 0 : 1;
  while (walk.enterNext()) {
    if (walk.rungs().isEmpty) {
      before = {};
      rung = 0;
      continue;
    }
    const int blockRung = rungIn(walk.rungs(), terms.fineness, transmittance);
    rung = std::max(rung, blockRung);
    const double chord = walk.exit() - walk.entry();
    for (double within = 0.0; within < chord;) {
      const bool hasSpentAll = spent >= most;
      const double rest = chord - within;
      const double length = hasSpentAll ? rest : pieceOf(rest, terms.stepMm(rung));
      const bool isLast = length == rest;
      const Half here = sample(isLast ? walk.exit() : walk.entry() + (within + length));
      const double change = changeOver(before, here, 0.5 * length);
      ++spent;
      if (!hasSpentAll && isToBeRefined(change, limit, rung)) {
        rung = refinedRung(rung, change, limit);
        continue;
      }
      add(before, 0.5 * length);
      transmittance = add(here, 0.5 * length);
      if (isEnd())
        return spent;
      rung = relaxedRung(rung, blockRung, change, limit);
      within = isLast ? chord : within + length;
      before = here;
    }
  }
  return spent;
}

/// One ray of a picture, from what it meets to its pixel (DEFINITION section 7).
template <class T>
class RayMarcher {
public:
  RayMarcher(const PictureTerms& terms, const FieldSampler<T>& field, const FramedRay& ray,
             const RaySpan& span, double offset)
      : m_terms(terms), m_field(field), m_ray(terms, field, ray, span, offset),
        m_light(lightAlong(ray.direction * terms.grid.spacingMm, terms.towardsLight)),
        m_samples(m_ray.count()) {}

  /// Of equal steps as many as the span has, of error-controlled ones those that `pixel` took.
  int samples() const { return m_samples; }

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
  using Material = typename RaySamples<T>::Material;
  using Steepness = typename RaySamples<T>::Steepness;

  // What a sample says of the piece for which it stands.
  struct Piece {
    double extinction = 0.0; // over the unit distance
    glm::dvec3 color{0.0};
    bool operator==(const Piece&) const = default;
  };

  // What comes of the light past what stands in its way.
  Reaching reachingAt(const glm::dvec3& centredIndex, const glm::dvec3& normal) const {
    Reaching reaching;
    if (!m_terms.lightPaths)
      return reaching;
    const LightPaths<T> paths(*m_terms.lightPaths, m_field);
    const LightingTerms& terms = m_terms.terms;
    if (m_terms.effects.has(Effect::shadow))
      reaching.direct = 1.0 - terms.shadow.strength * (1.0 - paths.ofLight(centredIndex));
    if (m_terms.effects.has(Effect::occlusion))
      reaching.ambient = 1.0 - terms.occlusion.strength * (1.0 - paths.ofSurroundings(centredIndex, normal));
    return reaching;
  }

  // The colour of a material at a place, lit and fogged.
  glm::dvec3 shaded(const glm::dvec3& material, double place, const Steepness& steepness) const {
    const LightingTerms& terms = m_terms.terms;
    const double flat = std::ldexp(m_terms.scale.largest, -20);
    const glm::dvec4& gradient = steepness.gradient;
    glm::dvec3 normal = gradient.w > flat ? -glm::dvec3(gradient) : glm::dvec3(0.0);
    if (m_terms.isCut && terms.usesNormal())
      normal = normalNearCut(m_terms.cut.lower, m_terms.cut.upper, m_terms.grid.spacingMm, m_terms.smallestMm,
                             m_ray.centredAt(place), m_ray.ray().direction, normal);
    const glm::dvec3 color =
        lit(terms, material, m_light, normal, steepness.ratio, reachingAt(m_ray.centredAt(place), normal));
    const double f = fogFactor(m_terms.scene.fog, m_ray.tAt(place) - m_ray.ray().eye);
    return f * color + (1.0 - f) * m_terms.scene.fog.color;
  }

  Piece pieceAt(double place, const Material& material) const {
    const Steepness steepness = m_ray.steepnessAt(place);
    const auto absorbed = m_ray.absorbedAt(place, material, steepness);
    return {absorbed.extinction, shaded(absorbed.color, place, steepness)};
  }

  // Composites front to back: adds a piece to the colour (rgb) and takes its share from the transmittance
  // (a).
  void add(const Piece& piece, double lengthMm, glm::dvec4& sum) const {
    const double weight = sum.a * m_ray.alphaOf(piece.extinction, lengthMm);
    sum = glm::dvec4(glm::dvec3(sum) + weight * piece.color, sum.a - weight);
  }

  // Takes error-controlled steps, whose places are in mm; `pieceAt` says what lies at one, and whether the
  // ray ends is asked behind each. The sum is that of `composite`.
  template <class PieceOf, class IsEnd>
  glm::dvec4 marchedLocally(const PieceOf& pieceOf, const IsEnd& isEnd) {
    m_ray.countInMm();
    glm::dvec4 sum(0.0, 0.0, 0.0, 1.0);
    const auto sample = [&](double place) {
      const Material material = m_ray.materialAt(place);
      return material.opacity > 0.0 ? pieceOf(place, material) : Piece{};
    };
    const auto change = [&](const Piece& before, const Piece& here, double halfMm) {
      const double was = m_ray.alphaOf(before.extinction, halfMm);
      const double is = m_ray.alphaOf(here.extinction, halfMm);
      const glm::dvec3 color = glm::abs(is * here.color - was * before.color);
      return 2.0 * sum.a * std::max({color.r, color.g, color.b, std::abs(is - was)});
    };
    const auto addPiece = [&](const Piece& piece, double lengthMm) {
      add(piece, lengthMm, sum);
      return sum.a;
    };
    // Who may take more equal samples than a driver can may do so here.
    const int mostInShader = m_terms.hasLooks ? mostLocalSamplesOfLooks : mostLocalSamples;
    const int most = m_terms.mostSamples > mostSamples ? m_terms.mostSamples : mostInShader;
    m_samples = marchLocally<Piece>(
        *m_terms.local, BlockWalk(*m_terms.local, m_ray.ray(), m_ray.span()), sample, change, addPiece,
        [&] { return isEnd(sum); }, most);
    return sum;
  }

  // Integrates cell by cell; `nodeOf(place, material)` says what lies at a place of a known material.
  template <class NodeOf, class IsEnd>
  glm::dvec4 marchedByCells(const NodeOf& nodeOf, const IsEnd& isEnd) {
    m_ray.countInMm();
    glm::dvec4 sum(0.0, 0.0, 0.0, 1.0);
    const auto node = [&](double place, std::size_t segment, double scalar) {
      const Piece piece = nodeOf(place, m_ray.materialIn(segment, place, scalar));
      return CellNode{piece.extinction, piece.color};
    };
    const auto add = [&](const CellLight& light) {
      sum = glm::dvec4(glm::dvec3(sum) + sum.a * light.color, sum.a - sum.a * light.alpha);
      return sum.a;
    };
    const int cuts = m_terms.mostSamples > mostSamples ? mostConvergingCuts : cellCuts;
    m_samples =
        CellMarch<T>(m_terms, m_ray).march(*m_terms.fineness, cuts, node, add, [&] { return isEnd(sum); });
    return sum;
  }

  glm::dvec4 composite() {
    const bool endsEarly = m_terms.scene.quality.earlyTermination < 1.0;
    const double last = lastTransmittance(m_terms.scene.quality.earlyTermination);
    const auto isEnd = [&](const glm::dvec4& sum) {
      return (endsEarly && sum.a <= last) || sum.a < nothingLeft;
    };
    if (m_terms.fineness || m_terms.local) {
      const auto piece = [&](double place, const Material& material) { return pieceAt(place, material); };
      const glm::dvec4 sum = m_terms.fineness ? marchedByCells(piece, isEnd) : marchedLocally(piece, isEnd);
      return {glm::dvec3(sum), 1.0 - sum.a};
    }
    glm::dvec4 sum(0.0, 0.0, 0.0, 1.0);
    for (int i = 0; i < m_ray.count(); ++i) {
      const double place = i + m_ray.offset();
      const Material material = m_ray.materialAt(place);
      if (!(material.opacity > 0.0))
        continue;
      add(pieceAt(place, material), m_ray.stepMm(), sum);
      if (isEnd(sum))
        break;
    }
    return {glm::dvec3(sum), 1.0 - sum.a};
  }

  glm::dvec3 surfaceColor(double place) const {
    const Classified classified = classify(m_terms.scene.transferFunction, m_terms.scene.isovalue);
    return shaded(classified.color, place, m_ray.steepnessAt(place));
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
    const RaySpan front{m_ray.span().begin, m_ray.tAt(*hit)};
    if (front.isEmpty())
      return {behind, 1.0};
    m_ray.divide(front);
    m_samples = m_ray.count();
    const glm::dvec4 before = composite();
    return {glm::dvec3(before) + (1.0 - before.a) * behind, 1.0};
  }

  glm::dvec4 xray() {
    if (m_terms.fineness || m_terms.local) {
      const auto piece = [this](double place, const Material& material) {
        return Piece{m_ray.absorptionAt(place, material), glm::dvec3(0.0)};
      };
      const auto never = [](const glm::dvec4&) { return false; };
      const glm::dvec4 sum = m_terms.fineness ? marchedByCells(piece, never) : marchedLocally(piece, never);
      return glm::dvec4(1.0 - sum.a);
    }
    double depth = 0.0;
    for (int i = 0; i < m_ray.count(); ++i)
      depth += m_ray.absorptionAt(i + m_ray.offset(), m_ray.materialAt(i + m_ray.offset()));
    return glm::dvec4(m_ray.alphaOf(depth, m_ray.stepMm()));
  }

  // The largest, smallest or mean scalar that is kept, classified once.
  glm::dvec4 classifiedOnce() const {
    const std::optional<double> scalar =
        m_terms.isExact ? CellScalars<T>(m_terms, m_ray).scalar(m_terms.scene.projection) : ofSamples();
    if (!scalar)
      return glm::dvec4(0.0);
    const Classified classified = classify(m_terms.scene.transferFunction, *scalar);
    return {classified.opacity * classified.color, classified.opacity};
  }

  std::optional<double> ofSamples() const {
    const Projection projection = m_terms.scene.projection;
    int kept = 0;
    double scalar = 0.0;
    for (int i = 0; i < m_ray.count(); ++i) {
      const double place = i + m_ray.offset();
      if (!m_ray.isKept(place))
        continue;
      const double next = m_ray.scalarAt(place);
      scalar = kept++ == 0                       ? next
               : projection == Projection::mip   ? std::max(scalar, next)
               : projection == Projection::minip ? std::min(scalar, next)
                                                 : scalar + next;
    }
    if (kept == 0)
      return std::nullopt;
    return projection == Projection::average ? scalar / kept : scalar;
  }

  // In steps from the entry.
  std::optional<double> firstHit() const {
    if (!m_terms.isExact)
      return m_ray.firstHit();
    const std::optional<double> hit = CellScalars<T>(m_terms, m_ray).firstAt(m_terms.scene.isovalue);
    return hit ? std::optional(*hit / m_ray.stepMm()) : std::nullopt;
  }

  // Light through so little cannot change the last digit of 1 in double precision, however bright.
  static constexpr double nothingLeft = 1e-20;

  // Of a piece of a picture that is to converge.
  static constexpr int mostConvergingCuts = 5;

  const PictureTerms& m_terms;
  const FieldSampler<T>& m_field;
  RaySamples<T> m_ray;
  RayLight m_light;
  int m_samples;
};

} // namespace limn
