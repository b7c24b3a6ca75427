// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/ProfileAlong.h"

#include "reference/RaySamples.h"

#include <algorithm>
#include <numeric>

namespace limn {
namespace {

// Finer than a picture: where half of the light is gathered is told to a part of a voxel.
constexpr double coarsestStep = 0.25;

// More could not be told apart in a chart, and it follows the pointer.
constexpr int mostPieces = 8192;

using Sample = RayProfile::Sample;

// One ray's samples in the order in which they are met.
template <class T>
class Profiler {
public:
  Profiler(const PictureTerms& terms, const FieldSampler<T>& field, const FramedRay& ray, const RaySpan& span)
      : m_terms(terms), m_ray(terms, field, ray, span, 0.5), m_whole(span) {}

  std::vector<Sample> samples() {
    switch (m_terms.scene.projection) {
    case Projection::composite:
      gather(m_whole);
      break;
    case Projection::xray:
      gather(m_whole);
      shareAlike();
      break;
    case Projection::isosurface:
    case Projection::compositeIsosurface:
      gatherAroundSurface();
      break;
    case Projection::mip:
    case Projection::minip:
    case Projection::average:
      classifyOnce();
      break;
    }
    return std::move(m_samples);
  }

private:
  Sample plainSample(double place) const {
    const double value = m_ray.scalarAt(place);
    const Classified classified = classify(m_terms.scene.transferFunction, value);
    return {m_ray.tAt(place) - m_whole.begin, m_ray.stepMm(), value, 0.0, 0.0, classified.color};
  }

  // Adds the pieces of a part of the ray, lit by what light is left there.
  void gather(const RaySpan& part) {
    if (part.isEmpty())
      return;
    m_ray.divide(part);
    const bool isXray = m_terms.scene.projection == Projection::xray;
    for (int i = 0; i < m_ray.count(); ++i) {
      const double place = i + m_ray.offset();
      Sample sample = plainSample(place);
      const auto material = m_ray.materialAt(place);
      if (m_terms.hasLooks)
        sample.color = material.color;
      if (material.opacity > 0.0) {
        const double extinction =
            isXray ? m_ray.absorptionAt(place, material)
                   : m_ray.absorbedAt(place, material, m_ray.steepnessAt(place)).extinction;
        sample.opacityPerMm = m_ray.alphaOf(extinction, 1.0);
        sample.contribution = m_light * m_ray.alphaOf(extinction, m_ray.stepMm());
        m_light -= sample.contribution;
        m_extinctions.push_back(extinction);
      } else {
        m_extinctions.push_back(0.0);
      }
      m_samples.push_back(sample);
    }
  }

  // Of an X-ray each piece counts by what it absorbs, whatever lies before it.
  void shareAlike() {
    const double sum = std::accumulate(m_extinctions.begin(), m_extinctions.end(), 0.0);
    const double alpha = 1.0 - m_light;
    for (std::size_t i = 0; i < m_samples.size(); ++i)
      m_samples[i].contribution = sum > 0.0 ? alpha * m_extinctions[i] / sum : 0.0;
  }

  void gatherAroundSurface() {
    const bool hasTissue = m_terms.scene.projection == Projection::compositeIsosurface;
    const std::optional<double> hit = m_ray.firstHit();
    if (!hit && hasTissue)
      return gather(m_whole);
    const double t = hit ? m_ray.tAt(*hit) : m_whole.end;
    Sample surface;
    if (hit)
      surface = plainSample(*hit);
    surface.color = classify(m_terms.scene.transferFunction, m_terms.scene.isovalue).color;
    surface.lengthMm = 0.0;
    surface.opacityPerMm = 1.0;
    hasTissue ? gather({m_whole.begin, t}) : pass({m_whole.begin, t});
    if (!hit)
      return;
    surface.contribution = m_light;
    m_samples.push_back(surface);
    m_light = 0.0;
    pass({t, m_whole.end});
  }

  // Adds pieces that give nothing.
  void pass(const RaySpan& part) {
    if (part.isEmpty())
      return;
    m_ray.divide(part);
    for (int i = 0; i < m_ray.count(); ++i)
      m_samples.push_back(plainSample(i + m_ray.offset()));
  }

  void classifyOnce() {
    const Projection projection = m_terms.scene.projection;
    pass(m_whole);
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < m_samples.size(); ++i) {
      const double place = static_cast<double>(i) + m_ray.offset();
      if (!m_ray.isKept(place))
        continue;
      kept.push_back(i);
      m_samples[i].opacityPerMm = classify(m_terms.scene.transferFunction, m_samples[i].value).opacity;
    }
    if (kept.empty())
      return;
    const auto valueOf = [this](std::size_t i) { return m_samples[i].value; };
    if (projection != Projection::average) {
      const std::size_t extreme = projection == Projection::mip
                                      ? *std::ranges::max_element(kept, {}, valueOf)
                                      : *std::ranges::min_element(kept, {}, valueOf);
      m_samples[extreme].contribution = m_samples[extreme].opacityPerMm;
      return;
    }
    double mean = 0.0;
    for (const std::size_t i : kept)
      mean += valueOf(i) / static_cast<double>(kept.size());
    const double alpha = classify(m_terms.scene.transferFunction, mean).opacity;
    for (const std::size_t i : kept)
      m_samples[i].contribution = alpha / static_cast<double>(kept.size());
  }

  const PictureTerms& m_terms;
  RaySamples<T> m_ray;
  RaySpan m_whole;
  std::vector<Sample> m_samples;
  std::vector<double> m_extinctions; ///< of the pieces that were gathered
  double m_light = 1.0;
};

} // namespace

std::optional<RayProfile> profileAlong(const Scene& scene, const GradientScale& scale, const Ray& ray) {
  if (!scene.volume)
    return std::nullopt;
  const Grid& grid = scene.volume->grid();
  PictureTerms terms{.scene = scene, .effects = {}, .scale = scale};
  terms.step = std::min(coarsestStep, scene.quality.stepVoxels) * smallestSpacingMm(grid);
  terms.mostSamples = mostPieces;
  const FramedRay framed{worldToIndex(grid, ray.origin) - terms.centre,
                         worldVectorToIndex(grid, ray.direction), 0.0};
  const RaySpan span = spanInBox(framed, terms.box);
  if (span.isEmpty())
    return std::nullopt;
  RayProfile profile;
  profile.projection = scene.projection;
  profile.entryMm = ray.origin + span.begin * ray.direction;
  profile.direction = ray.direction;
  profile.lengthMm = span.end - span.begin;
  visitVoxels(*scene.volume, [&]<class T>(const StoredVoxels<T>& stored) {
    const FieldSampler<T> field(*scene.volume, stored);
    profile.samples = Profiler<T>(terms, field, framed, span).samples();
  });
  for (const Sample& sample : profile.samples)
    profile.alpha += sample.contribution;
  return profile;
}

} // namespace limn
