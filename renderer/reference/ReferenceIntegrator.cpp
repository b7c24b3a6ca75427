// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/ReferenceIntegrator.h"

#include "reference/FieldSampler.h"
#include "reference/SampleLighting.h"
#include "scene/EffectSet.h"
#include "scene/Error.h"
#include "scene/StableMath.h"

#include <atomic>
#include <thread>

namespace limn {
namespace {

// What every ray of a picture shares.
struct Marcher {
  const Scene& scene;
  const Grid& grid = scene.volume->grid();
  LightingTerms terms = lightingTerms(scene.shading);
  IndexBox box = croppedBox(grid, scene.crop);
  CutPlanes cut = cutPlanes(grid, scene.crop);
  bool isCut = scene.crop != CropBox{};
  double step = stepMm(scene);
  double smallestMm = smallestSpacingMm(grid);
  glm::dvec3 centre = centreIndex(grid);
  std::optional<glm::dvec3> towardsLight =
      terms.lightDirection ? std::optional(towardsLightAlongAxes(*terms.lightDirection, grid)) : std::nullopt;
  bool hasGradientOpacity = scene.gradientOpacity && !scene.gradientOpacity->points.empty();
  bool readsGradient = terms.usesNormal() || terms.usesRatio() || hasGradientOpacity;
  GradientScale scale = readsGradient ? gradientScale(*scene.volume, scene.shading) : GradientScale{};

  template <class T>
  glm::dvec4 march(const FieldSampler<T>& field, const FramedRay& ray, const RaySpan& span, int count) const;

  template <class T>
  void addSample(const FieldSampler<T>& field, const Cell& cell, const Classified& classified,
                 const glm::dvec3& centred, double fromEye, const RayLight& light, double units,
                 glm::dvec4& sum) const;
};

// Adds a visible sample to the colour (rgb) and takes its share from the transmittance (a).
template <class T>
void Marcher::addSample(const FieldSampler<T>& field, const Cell& cell, const Classified& classified,
                        const glm::dvec3& centred, double fromEye, const RayLight& light, double units,
                        glm::dvec4& sum) const {
  glm::dvec4 gradient(0.0);
  double ratio = 0.0;
  if (readsGradient) {
    gradient = safeNormal(field.gradientAt(cell));
    ratio = gradientRatio(terms, scale, gradient.w);
  }

  // Change the opacity before it becomes an extinction, so that the picture does not depend on the step.
  double opacity = classified.opacity * mapped(ratio, terms.opacity.atFlat, terms.opacity.atBoundary);
  if (hasGradientOpacity)
    opacity *= gradientOpacityAt(*scene.gradientOpacity, gradient.w);
  const double alpha = oneMinusExpNeg(minusLog1mOpacity(opacity) * units);

  glm::dvec3 normal = gradient.w > std::ldexp(scale.largest, -20) ? -glm::dvec3(gradient) : glm::dvec3(0.0);
  if (isCut && terms.usesNormal())
    normal = normalNearCut(cut, grid.spacingMm, smallestMm, centred, normal);
  glm::dvec3 color = lit(terms, classified.color, light, normal, ratio);
  const double f = fogFactor(scene.fog, fromEye);
  color = f * color + (1.0 - f) * scene.fog.color;

  // Composite front to back.
  const double weight = sum.a * alpha;
  sum = glm::dvec4(glm::dvec3(sum) + weight * color, sum.a - weight);
}

template <class T>
glm::dvec4 Marcher::march(const FieldSampler<T>& field, const FramedRay& ray, const RaySpan& span,
                          int count) const {
  const double dt = (span.end - span.begin) / count;
  const double units = dt / scene.transferFunction.unitDistanceMm;
  const RayLight light = lightAlong(ray.direction * grid.spacingMm, towardsLight);
  const bool endsEarly = scene.quality.earlyTermination < 1.0;
  const double last = lastTransmittance(scene.quality.earlyTermination);
  glm::dvec4 sum(0.0, 0.0, 0.0, 1.0);
  for (int i = 0; i < count; ++i) {
    const double t = span.begin + (i + 0.5) * dt;
    const glm::dvec3 centred = ray.anchor + t * ray.direction;
    const Cell cell = field.cellAt(centred + centre);
    const Classified classified = classify(scene.transferFunction, field.scalarAt(cell));
    if (!(classified.opacity > 0.0))
      continue;
    addSample(field, cell, classified, centred, t - ray.eye, light, units, sum);
    if (endsEarly && sum.a <= last)
      break;
  }
  return {glm::dvec3(sum), 1.0 - sum.a};
}

// Hands out rows to threads until none is left or the work is cancelled.
template <class Function>
void forEachRow(int rows, int threads, const std::function<bool()>& isCancelled, const Function& function) {
  std::atomic<int> next{0};
  std::atomic<bool> stop{false};
  const auto work = [&](bool asks) {
    for (int row = next++; row < rows && !stop; row = next++) {
      if (asks && isCancelled && isCancelled())
        stop = true;
      else
        function(row);
    }
  };
  {
    // The caller's question is asked on the caller's thread only.
    std::vector<std::jthread> helpers;
    for (int i = 1; i < threads; ++i)
      helpers.emplace_back(work, false);
    work(true);
  }
  if (stop)
    throw Cancelled();
}

} // namespace

ReferencePicture renderReference(const Scene& scene, const glm::ivec2& size, int threads,
                                 const std::function<bool()>& isCancelled) {
  requireDrawable(scene);
  ReferencePicture picture{size, {}, {}};
  const auto pixels = static_cast<std::size_t>(size.x) * size.y;
  picture.pixels.assign(pixels, glm::dvec4(0.0));
  picture.samples.assign(pixels, 0);
  const Marcher marcher{scene};
  const RayFrame frame = rayFrame(scene.camera, scene.volume->grid(), size);
  if (threads <= 0)
    threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  visitVoxels(*scene.volume, [&]<class T>(const std::vector<T>& stored) {
    const FieldSampler<T> field(*scene.volume, stored);
    forEachRow(size.y, threads, isCancelled, [&](int y) {
      for (int x = 0; x < size.x; ++x) {
        const FramedRay ray = framedRay(frame, x, y, size);
        const RaySpan span = spanInBox(ray, marcher.box);
        if (span.isEmpty())
          continue;
        const auto pixel = static_cast<std::size_t>(y) * size.x + x;
        picture.samples[pixel] = sampleCount(span.end - span.begin, marcher.step);
        picture.pixels[pixel] = marcher.march(field, ray, span, picture.samples[pixel]);
      }
    });
  });
  return picture;
}

Image toImage(const ReferencePicture& picture) {
  Image image(picture.size);
  std::transform(picture.pixels.begin(), picture.pixels.end(), image.pixels.begin(),
                 [](const glm::dvec4& pixel) { return glm::vec4(pixel); });
  return image;
}

} // namespace limn
