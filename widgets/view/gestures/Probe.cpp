// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/gestures/Probe.h"

#include "scene/LabelLooks.h"
#include "scene/basics/StableMath.h"
#include "scene/light/GradientField.h"
#include "scene/light/LightingTerms.h"
#include "scene/steps/RayFrame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace limn {
namespace {

// A probe answers at the speed of the pointer; further samples could not be told apart on the screen.
constexpr double mostReadings = 8192.0;

// What samples absorb as the side's model, the kept region and the looks of its labels show them (DEFINITION
// sections 3, 5 and 10).
class SampleExtinction {
public:
  SampleExtinction(const Scene& scene, const GradientScale& scale)
      : m_scene(scene), m_scale(scale), m_terms(lightingTerms(scene.shading)),
        m_isRestricted(isRestricting(scene.keep)), m_looks(labelLooks(scene)) {}

  // Whether projections of extremes and surfaces take a sample.
  bool isKept(const glm::dvec3& index) const {
    return !m_isRestricted || weightAt(m_scene.keep, index) >= 0.5;
  }

  // Per millimetre.
  double at(const glm::dvec3& index, double value) const {
    if (m_looks.areAny())
      return mixedAt(index, value);
    const double opacity = classify(m_scene.transferFunction, value).opacity *
                           (m_isRestricted ? weightAt(m_scene.keep, index) : 1.0);
    return extinctionPerMm(std::clamp(opacity > 0.0 ? factorAt(index) * opacity : 0.0, 0.0, 1.0),
                           m_scene.transferFunction.unitDistanceMm);
  }

private:
  double mixedAt(const glm::dvec3& index, double value) const {
    double extinction = 0.0;
    std::optional<double> factor; // where anything shows
    const auto shares = lookSharesAt(m_looks, m_scene.keep, index);
    for (const LookShare& share : shares.used()) {
      const TransferFunction& function = m_looks.functions[share.look];
      const double opacity = classify(function, value).opacity * share.weight;
      if (opacity <= 0.0)
        continue;
      if (!factor)
        factor = factorAt(index);
      extinction +=
          share.share * extinctionPerMm(std::clamp(*factor * opacity, 0.0, 1.0), function.unitDistanceMm);
    }
    return extinction;
  }

  // What model and gradient opacity make of opacities.
  double factorAt(const glm::dvec3& index) const {
    if (!m_terms.mapsOpacity() && !m_scene.gradientOpacity)
      return m_terms.opacity.atFlat;
    const double modulus = glm::length(followedGradientAt(*m_scene.volume, m_scale, index));
    const double boundary =
        mapped(gradientRatio(m_terms, m_scale, modulus), m_terms.opacity.atFlat, m_terms.opacity.atBoundary);
    const double curve = m_scene.gradientOpacity ? gradientOpacityAt(*m_scene.gradientOpacity, modulus) : 1.0;
    return curve * boundary;
  }

  const Scene& m_scene;
  GradientScale m_scale;
  LightingTerms m_terms;
  bool m_isRestricted;
  LabelLooks m_looks;
};

// How much each sample speaks for itself; the largest one is what the pixel shows.
class Contribution {
public:
  Contribution(const Scene& scene, const GradientScale& scale) : m_scene(scene), m_extinction(scene, scale) {}

  double of(const glm::dvec3& index, double value, double stepMm) {
    switch (m_scene.projection) {
    case Projection::mip:
    case Projection::minip:
      if (!m_extinction.isKept(index))
        return nothing;
      m_hasSample = true;
      return m_scene.projection == Projection::mip ? value : -value;
    case Projection::isosurface:
      return crosses(value, index) ? 1.0 : 0.0;
    case Projection::compositeIsosurface:
      if (crosses(value, index))
        return std::exchange(m_transmittance, 0.0);
      break;
    case Projection::composite:
    case Projection::average:
    case Projection::xray:
      break;
    }
    const double seen = m_transmittance * oneMinusExpNeg(m_extinction.at(index, value) * stepMm);
    m_transmittance -= seen;
    return seen;
  }

  // What lies behind can no longer be the largest.
  bool isDecided(double largest) const { return !isExtreme() && m_transmittance < largest; }

  bool isExtreme() const {
    return m_scene.projection == Projection::mip || m_scene.projection == Projection::minip;
  }
  // Half an 8-bit level of alpha.
  bool sawSomething() const {
    return isExtreme() ? m_hasSample : m_crossed || m_transmittance < 1.0 - 1.0 / 510.0;
  }

private:
  // Less than any value.
  static constexpr double nothing = -std::numeric_limits<double>::infinity();

  bool crosses(double value, const glm::dvec3& index) {
    const bool above = value >= m_scene.isovalue && m_extinction.isKept(index);
    const bool crossed = m_started ? above != m_above : above;
    m_started = true;
    m_above = above;
    return crossed && !std::exchange(m_crossed, m_crossed || crossed);
  }

  const Scene& m_scene;
  SampleExtinction m_extinction;
  double m_transmittance = 1.0;
  bool m_hasSample = false; ///< of an extreme
  bool m_started = false;
  bool m_above = false;
  bool m_crossed = false;
};

} // namespace

std::optional<Probe> probeAlong(const Scene& scene, const GradientScale& scale, const Ray& ray) {
  if (!scene.volume)
    return std::nullopt;
  const Grid& grid = scene.volume->grid();
  const glm::dvec3 centre = centreIndex(grid);
  const FramedRay framed{worldToIndex(grid, ray.origin) - centre, worldVectorToIndex(grid, ray.direction),
                         0.0};
  const RaySpan inside = spanInBox(framed, croppedBox(grid, scene.crop));
  if (inside.isEmpty())
    return std::nullopt;

  const double length = inside.end - inside.begin;
  const double wantedStep = std::min(0.5, scene.quality.stepVoxels) * smallestSpacingMm(grid);
  const int samples = static_cast<int>(std::clamp(std::ceil(length / wantedStep), 1.0, mostReadings));
  const double stepMm = length / samples;

  Contribution contribution(scene, scale);
  double largest = contribution.isExtreme() ? -std::numeric_limits<double>::infinity() : 0.0;
  std::optional<Probe> found;
  for (int i = 0; i < samples && !contribution.isDecided(largest); ++i) {
    const double t = inside.begin + (i + 0.5) * stepMm;
    const glm::dvec3 index = framed.anchor + t * framed.direction + centre;
    const double value = valueAt(*scene.volume, index);
    const double seen = contribution.of(index, value, stepMm);
    if (seen > largest) {
      largest = seen;
      found = Probe{value, ray.origin + t * ray.direction, index};
    }
  }
  return contribution.sawSomething() ? found : std::nullopt;
}

std::optional<Ray> rayUnder(const ViewGeometry& geometry, const Camera& camera, const QPointF& point) {
  const std::vector<PixelRect> places = pictureRects(geometry);
  if (places.empty())
    return std::nullopt;
  const PixelRect& place = places[static_cast<std::size_t>(positionAt(geometry, point))];
  const glm::dvec2 position = glm::dvec2(point.x(), point.y()) * geometry.pixelRatio;
  const glm::ivec2 pixel = glm::ivec2(glm::floor(position)) - place.topLeft;
  const bool inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < place.size.x && pixel.y < place.size.y;
  return inside ? std::optional(rayThroughPixel(camera, pixel.x, pixel.y, place.size)) : std::nullopt;
}

} // namespace limn
