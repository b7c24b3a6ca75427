// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/ReferenceIntegrator.h"

#include "reference/RayMarcher.h"
#include "reference/SmoothedField.h"
#include "scene/basics/Error.h"
#include "scene/effects/EffectPlan.h"

#include <atomic>
#include <cassert>
#include <limits>
#include <thread>

namespace limn {
namespace {

// Only how the ray is sampled follows the plan, pre-integrated or not, jittered or not; and whether light
// travels.
EffectSet effectsOf(const Scene& scene) {
  SceneFacts facts;
  if (readsSteepness(scene))
    facts.steepestPerMm = steepness(*scene.volume);
  return requiredEffects(scene, facts).effects;
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

// What is drawn, and by how many.
struct Work {
  const std::vector<std::uint8_t>* wanted = nullptr; ///< absent: every pixel
  int threads = 0;
  const std::function<bool()>& isCancelled;
  Limiting limiting = Limiting::clampOrKnee;
  int mostSamples = limn::mostSamples;
  std::optional<PixelRect> tile; ///< absent: the whole picture
  ToTolerance way = ToTolerance::byCells;
};

// The field whose gradients smooth normals follow.
struct Smoothed {
  Smoothed(const Scene& scene, const Effort& effort)
      : volume(smoothedField(*scene.volume, scene.shading.gradientSmoothing, effort)),
        sampler(volume, std::get<StoredVoxels<double>>(volume.stored())),
        scale(gradientScale(volume, scene.shading, effort)) {}

  Volume volume;
  FieldSampler<double> sampler;
  GradientScale scale;
};

void drawInto(ReferencePicture& picture, const Scene& scene, const Work& work) {
  requireDrawable(scene);
  if (isPhysical(scene))
    throw Error(Error::Kind::usage, Message::tr("The reference follows no random paths and cannot draw "
                                                "physical light; use --engine cpu or another model."));
  const glm::ivec2 size = picture.size;
  const PixelRect tile = work.tile.value_or(PixelRect{{0, 0}, size});
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const int threads = work.threads > 0 ? work.threads : cores;
  std::optional<Smoothed> smoothed;
  if (smoothsNormals(scene))
    smoothed.emplace(scene, Effort{threads, work.isCancelled, {}});
  const bool isByCells = work.way == ToTolerance::byCells;
  PictureTerms terms = smoothed ? PictureTerms{.scene = scene,
                                               .effects = effectsOf(scene),
                                               .isByCells = isByCells,
                                               .smoothed = &smoothed->sampler,
                                               .scale = smoothed->scale}
                                : PictureTerms{scene, effectsOf(scene), isByCells};
  terms.mostSamples = work.mostSamples;
  terms.terms.isUnlimited = work.limiting == Limiting::none;
  std::optional<PictureTerms> paths;
  if (terms.effects.hasAny(travellingLight))
    terms.lightPaths = &paths.emplace(lightPathTerms(terms));
  const RayFrame frame = rayFrame(scene.camera, scene.volume->grid(), size);
  visitVoxels(*scene.volume, [&]<class T>(const StoredVoxels<T>& stored) {
    const FieldSampler<T> field(*scene.volume, stored);
    forEachRow(tile.size.y, threads, work.isCancelled, [&](int row) {
      const int y = tile.topLeft.y + row;
      for (int x = tile.topLeft.x; x < tile.topLeft.x + tile.size.x; ++x) {
        const auto pixel = static_cast<std::size_t>(y) * size.x + x;
        if (work.wanted && !(*work.wanted)[pixel])
          continue;
        const FramedRay ray = framedRay(frame, x, y, size);
        const RaySpan span = spanInBox(ray, terms.box);
        if (span.isEmpty())
          continue;
        const bool isJittered = terms.effects.has(Effect::jitter);
        const double offset = isJittered ? jitteredOffset(x, y, size.y) : 0.5;
        RayMarcher<T> marcher(terms, field, ray, span, offset);
        picture.pixels[pixel] = marcher.pixel();
        picture.samples[pixel] = marcher.samples();
      }
    });
  });
}

} // namespace

ReferencePicture renderReference(const Scene& scene, const glm::ivec2& size, int threads,
                                 const std::function<bool()>& isCancelled, Limiting limiting,
                                 const std::optional<PixelRect>& tile, ToTolerance way) {
  ReferencePicture picture{size, {}, {}};
  const auto pixels = static_cast<std::size_t>(size.x) * size.y;
  picture.pixels.assign(pixels, glm::dvec4(0.0));
  picture.samples.assign(pixels, 0);
  drawInto(picture, scene, {nullptr, threads, isCancelled, limiting, mostSamples, tile, way});
  return picture;
}

void redrawReference(ReferencePicture& picture, const Scene& scene, const std::vector<std::uint8_t>& wanted,
                     int threads, const std::function<bool()>& isCancelled) {
  assert(wanted.size() == picture.pixels.size());
  drawInto(picture, scene,
           {&wanted, threads, isCancelled, Limiting::clampOrKnee, std::numeric_limits<int>::max(), {}, {}});
}

Image toImage(const ReferencePicture& picture) {
  Image image(picture.size);
  std::transform(picture.pixels.begin(), picture.pixels.end(), image.pixels.begin(),
                 [](const glm::dvec4& pixel) { return glm::vec4(pixel); });
  return image;
}

} // namespace limn
