// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/paths/TracePaths.h"

#include "cpu/paths/PathScene.h"
#include "cpu/paths/PathTracer.h"
#include "cpu/rays/Threads.h"

#include <algorithm>

namespace limn::cpu {
namespace {

// So many pixels side by side have so many paths each in one piece of work: milliseconds.
constexpr int pixelsAtOnce = 16;
constexpr int pathsAtOnce = 4;

// In thin tissue most paths meet nothing: so often the first collision of one is looked for. What shows there
// is faint, so that more tries cost more than they better.
constexpr int mostTries = 4;

template <class T>
void traceAll(const PathTerms& paths, const PictureTerms& terms, std::uint32_t seed, const PixelRect& covered,
              int count, int threads, const std::function<bool()>& isCancelled, PathPicture& picture) {
  const LinearSky sky{paths};
  const PathTracer<T> tracer(paths, sky);
  const auto tracePixel = [&](int x, int y, int end) {
    PixelPaths& pixel = picture.at(x, y);
    if (pixel.paths >= end)
      return;
    const PathStart start = pixel.alpha > 0.0f ? pathStart(paths, terms, x, y) : PathStart{};
    for (; pixel.paths < end; ++pixel.paths) {
      if (!(start.length > 0.0f))
        continue;
      PathRandom random(seed, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y),
                        static_cast<std::uint32_t>(pixel.paths));
      const auto found = tracer.radiance(start, random, mostTries);
      if (!found)
        continue;
      const glm::dvec3 radiance(*found);
      if (pixel.met++ % 2 == 0)
        pixel.half += *found;
      pixel.sum += radiance;
      pixel.squares += radiance * radiance;
    }
  };
  int fewest = count;
  for (int y = 0; y < covered.size.y; ++y)
    for (int x = 0; x < covered.size.x; ++x)
      fewest = std::min(fewest, picture.at(covered.topLeft.x + x, covered.topLeft.y + y).paths);
  for (int done = fewest; done < count;) {
    done = std::min(done + pathsAtOnce, count);
    forEachStrip(
        covered, covered, threads,
        [&](const Strip& strip) {
          for (int x = strip.fromX; x < strip.toX; ++x)
            tracePixel(x, strip.y, done);
        },
        isCancelled, pixelsAtOnce);
  }
}

// So many first collisions of each pixel: a guide without noise of its own to speak of, for the price of a
// path or two.
constexpr int guidesOfPixel = 16;

template <class T>
void traceGuides(const PathTerms& paths, const PictureTerms& terms, std::uint32_t seed,
                 const PixelRect& covered, const Effort& effort, const PathPicture& picture,
                 PathGuides& guides) {
  const LinearSky sky{paths};
  const PathTracer<T> tracer(paths, sky);
  forEachStrip(
      covered, covered, effort.threads,
      [&](const Strip& strip) {
        for (int x = strip.fromX; x < strip.toX; ++x) {
          const std::size_t n = static_cast<std::size_t>(strip.y) * picture.size().x + x;
          if (!(picture.pixels()[n].alpha > 0.0f))
            continue;
          const PathStart start = pathStart(paths, terms, x, strip.y);
          float count = 0.0f;
          for (std::uint32_t i = 0; i < guidesOfPixel; ++i) {
            PathRandom random(~seed, static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(strip.y), i);
            const auto met = start.length > 0.0f ? tracer.firstMet(start, random, mostTries) : std::nullopt;
            if (!met)
              continue;
            guides.albedo[n] += met->albedo;
            guides.normal[n] += met->normal;
            guides.depth[n] += met->depth;
            count += 1.0f;
          }
          guides.albedo[n] /= std::max(count, 1.0f);
          guides.normal[n] /= std::max(count, 1.0f);
          guides.depth[n] /= std::max(count, 1.0f);
        }
      },
      effort.isCancelled, pixelsAtOnce);
}

// Calls `work` with a number of the type in which voxels are stored.
template <class Work>
void withStored(VoxelSource::Kind kind, const Work& work) {
  switch (kind) {
  case VoxelSource::Kind::byte:
    return work(std::uint8_t{});
  case VoxelSource::Kind::signedByte:
    return work(std::int8_t{});
  case VoxelSource::Kind::half:
    return work(std::uint16_t{});
  case VoxelSource::Kind::signedHalf:
    return work(std::int16_t{});
  case VoxelSource::Kind::single:
    return work(float{});
  }
}

} // namespace

void tracePaths(const PathTerms& paths, const PictureTerms& terms, std::uint32_t seed,
                const PixelRect& covered, int count, int threads, const std::function<bool()>& isCancelled,
                PathPicture& picture) {
  withStored(paths.voxels.kind, [&]<class T>(T) {
    traceAll<T>(paths, terms, seed, covered, count, threads, isCancelled, picture);
  });
}

PathGuides tracedGuides(const PathTerms& paths, const PictureTerms& terms, std::uint32_t seed,
                        const PixelRect& covered, const Effort& effort, const PathPicture& picture) {
  const std::size_t count = picture.pixels().size();
  PathGuides guides{std::vector(count, glm::vec3(0.0f)), std::vector(count, glm::vec3(0.0f)),
                    std::vector(count, 0.0f)};
  withStored(paths.voxels.kind,
             [&]<class T>(T) { traceGuides<T>(paths, terms, seed, covered, effort, picture, guides); });
  return guides;
}

} // namespace limn::cpu
