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
      ++pixel.met;
      const glm::dvec3 radiance(*found);
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

} // namespace

void tracePaths(const PathTerms& paths, const PictureTerms& terms, std::uint32_t seed,
                const PixelRect& covered, int count, int threads, const std::function<bool()>& isCancelled,
                PathPicture& picture) {
  const auto trace = [&]<class T>(T) {
    traceAll<T>(paths, terms, seed, covered, count, threads, isCancelled, picture);
  };
  switch (paths.voxels.kind) {
  case VoxelSource::Kind::byte:
    return trace(std::uint8_t{});
  case VoxelSource::Kind::signedByte:
    return trace(std::int8_t{});
  case VoxelSource::Kind::half:
    return trace(std::uint16_t{});
  case VoxelSource::Kind::signedHalf:
    return trace(std::int16_t{});
  case VoxelSource::Kind::single:
    return trace(float{});
  }
}

} // namespace limn::cpu
