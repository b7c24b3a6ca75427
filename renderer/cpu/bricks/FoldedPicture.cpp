// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/bricks/FoldedPicture.h"

#include <algorithm>
#include <deque>

namespace limn {
namespace {

// Of pictures whose bricks each find scalars.
Image foldedScalars(std::deque<BrickRenderer>& renderers, const PixelRect& tile) {
  std::vector<ScalarShare> folded = renderers.front().scalars(tile);
  const bool isSum = renderers.front().folding() == Folding::sum;
  for (std::size_t i = 1; i < renderers.size(); ++i) {
    const std::vector<ScalarShare> share = renderers[i].scalars(tile);
    std::ranges::transform(folded, share, folded.begin(),
                           [isSum](const auto& a, const auto& b) { return isSum ? a + b : glm::max(a, b); });
  }
  return renderers.front().classified(tile, folded);
}

std::vector<SurfaceHits> hitsOf(std::deque<BrickRenderer>& renderers, const PixelRect& tile) {
  std::vector<SurfaceHits> hits(renderers.size());
  if (!renderers.front().hasSurface())
    return hits;
  std::vector<float> nearest;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    hits[i].own = renderers[i].hits(tile);
    if (nearest.empty())
      nearest = hits[i].own;
    std::ranges::transform(nearest, hits[i].own, nearest.begin(),
                           [](float a, float b) { return std::min(a, b); });
  }
  for (SurfaceHits& ofBrick : hits)
    ofBrick.nearest = nearest;
  return hits;
}

} // namespace

Image drawInBricks(const Scene& scene, const glm::ivec2& size, int count, int threads) {
  requireDrawable(scene);
  const Bricks bricks(scene.volume->grid(), scene.crop, count);
  const std::vector<int> order = bricks.frontToBack(rayFrame(scene.camera, scene.volume->grid(), size));
  std::deque<BrickRenderer> renderers;
  for (const int brick : order)
    renderers.emplace_back(threads).begin(scene, size, bricks.box(brick));
  const PixelRect whole{{0, 0}, size};
  if (renderers.front().folding() != Folding::over)
    return foldedScalars(renderers, whole);
  const std::vector<SurfaceHits> hits = hitsOf(renderers, whole);
  Image folded(size);
  for (std::size_t place = renderers.size(); place-- > 0;) {
    const Image share = renderers[place].share(whole, hits[place]);
    foldOver(share.pixels.data(), folded.pixels.data(), folded.pixels.size());
  }
  return folded;
}

} // namespace limn
