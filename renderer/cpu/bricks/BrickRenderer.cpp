// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/bricks/BrickRenderer.h"

#include "cpu/rays/Threads.h"
#include "cpu/simd/DrawRow.h"
#include "cpu/simd/InstructionSet.h"
#include "engine/VolumeTooLarge.h"
#include "scene/basics/Error.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <deque>
#include <limits>
#include <thread>

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

// Beyond every volume, and far enough from infinity to be divided by a direction.
constexpr double farAway = 1e30;

// Of a brick of so many slices the ones that it needs beyond its own, up to eight on a side, are a half.
constexpr double leastSlices = 32.0;

// Of axes of equal length the last: what lies together in a file stays together.
int longestAxis(const glm::dvec3& size) {
  int longest = 2;
  for (int axis = 1; axis >= 0; --axis)
    if (size[axis] > size[longest])
      longest = axis;
  return longest;
}

std::size_t pixelsOf(const PixelRect& tile) {
  return static_cast<std::size_t>(tile.size.x) * static_cast<std::size_t>(tile.size.y);
}

int allOr(int threads) {
  return threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
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

Bricks::Bricks(const Grid& grid, const CropBox& crop, int count, bool inSlices)
    : m_boxes(static_cast<std::size_t>(count)) {
  const IndexBox whole = croppedBox(grid, crop);
  const bool isThick = whole.upper.z - whole.lower.z >= leastSlices * count;
  divide(whole, {glm::dvec3(-farAway), glm::dvec3(farAway)}, 0, count,
         inSlices && isThick ? std::optional(2) : std::nullopt);
}

void Bricks::divide(const IndexBox& inner, const IndexBox& outer, int first, int count,
                    std::optional<int> across) {
  if (count == 1) {
    m_boxes[static_cast<std::size_t>(first)] = outer;
    return;
  }
  const int below = count / 2;
  const glm::dvec3 size = inner.upper - inner.lower;
  const int axis = across.value_or(longestAxis(size));
  const double plane = inner.lower[axis] + size[axis] * below / count;
  m_splits.push_back({first, below, count, axis, plane});
  IndexBox innerBelow = inner, innerAbove = inner, outerBelow = outer, outerAbove = outer;
  innerBelow.upper[axis] = innerAbove.lower[axis] = plane;
  outerBelow.upper[axis] = outerAbove.lower[axis] = plane;
  divide(innerBelow, outerBelow, first, below, across);
  divide(innerAbove, outerAbove, first + below, count - below, across);
}

std::vector<int> Bricks::frontToBack(const RayFrame& frame) const {
  // The middle ray's: where rays are parallel the direction of all, otherwise through the eye of all.
  const glm::dvec3 eye = frame.anchor - frame.anchorDistanceMm * frame.direction;
  const bool isParallel = frame.tangentPerPixel == 0.0;
  std::vector<int> order(m_boxes.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = static_cast<int>(i);
  // The parts of a split lie side by side in the order whatever splits within them did, so that turning
  // them is swapping two runs; inner splits first.
  for (auto split = m_splits.rbegin(); split != m_splits.rend(); ++split) {
    const bool lowerIsNear =
        isParallel ? frame.direction[split->axis] > 0.0 : eye[split->axis] < split->plane;
    const auto begin = order.begin() + split->first;
    if (!lowerIsNear)
      std::rotate(begin, begin + split->below, begin + split->count);
  }
  return order;
}

VoxelBox ownVoxels(const Grid& grid, const IndexBox& brick) {
  const auto firstAtOrAbove = [&](const glm::dvec3& face) {
    return glm::ivec3(
        glm::clamp(glm::ceil(face + centreIndex(grid)), glm::dvec3(0.0), glm::dvec3(grid.dims)));
  };
  return {firstAtOrAbove(brick.lower), firstAtOrAbove(brick.upper)};
}

VoxelBox voxelsRead(const Grid& grid, const IndexBox& brick, double stepVoxels) {
  return cpu::voxelsOf(cpu::blocksMet(grid, brick, stepVoxels), grid.dims);
}

BrickRenderer::BrickRenderer(int threads) : m_threads(allOr(threads)), m_data(m_threads, true) {
  cpu::requireInstructionSet();
}

void BrickRenderer::begin(const Scene& scene, const glm::ivec2& size, const IndexBox& brick,
                          const std::function<bool()>& isCancelled) {
  m_isCancelled = isCancelled;
  if (hasTravellingLight(scene))
    throw Error(
        Error::Kind::usage,
        Message::tr("Shadows and occlusion cannot be drawn in bricks: light crosses from one to the next. "
                    "Draw the picture with limn, or set their strength to 0."));
  if (smoothsNormals(scene))
    throw Error(
        Error::Kind::usage,
        Message::tr("Smooth normals cannot be drawn in bricks: smoothing reaches beyond each of them. "
                    "Draw the picture with limn, or set the smoothing to 0."));
  if (isPhysical(scene))
    throw Error(Error::Kind::usage,
                Message::tr("Physical light cannot be drawn in bricks: its paths cross from one to the next. "
                            "Draw the picture with limn, or choose another model."));
  m_covered = {};
  m_data.setBrick(brick);
  m_data.update(scene, isCancelled);
  m_limitation = stepLimitation(scene, mostSamples);
  m_plan = requiredEffects(scene, m_data.facts(scene));
  m_terms = {};
  if (!m_plan.isVisible)
    return;
  m_terms = m_data.terms(scene, size, m_plan.effects, isCancelled);
  m_covered = coveredPixels(scene.camera, scene.volume->grid(), m_terms.visibleBox, size);
}

Folding BrickRenderer::folding() const {
  if (m_plan.effects.has(Effect::average))
    return Folding::sum;
  return m_plan.effects.hasAny(scalarProjections) ? Folding::largest : Folding::over;
}

bool BrickRenderer::hasSurface() const {
  return m_plan.effects.has(Effect::isosurface) || m_plan.effects.has(Effect::hybrid);
}

std::vector<float> BrickRenderer::hits(const PixelRect& tile) {
  std::vector<float> hits(pixelsOf(tile), std::numeric_limits<float>::infinity());
  const auto find = [&](const cpu::Strip& strip) {
    cpu::findHits(m_terms, strip.y, strip.fromX, strip.toX, &hits[strip.inTile]);
  };
  cpu::forEachStrip(tile, intersection(tile, m_covered), m_threads, find, m_isCancelled);
  return hits;
}

Image BrickRenderer::share(const PixelRect& tile, const SurfaceHits& hits) {
  Image share(tile.size);
  assert(!hasSurface() || (hits.own.size() == pixelsOf(tile) && hits.nearest.size() == pixelsOf(tile)));
  std::atomic<std::int64_t> samples = 0;
  const auto draw = [&](const cpu::Strip& strip) {
    const float* own = hasSurface() ? &hits.own[strip.inTile] : nullptr;
    const float* nearest = hasSurface() ? &hits.nearest[strip.inTile] : nullptr;
    samples += cpu::drawShares(m_terms, strip.y, strip.fromX, strip.toX, {own, nearest},
                               &share.pixels[strip.inTile]);
  };
  cpu::forEachStrip(tile, intersection(tile, m_covered), m_threads, draw, m_isCancelled);
  m_samples += samples;
  return share;
}

std::vector<ScalarShare> BrickRenderer::scalars(const PixelRect& tile) {
  const double none = folding() == Folding::sum ? 0.0 : -std::numeric_limits<double>::infinity();
  std::vector<ScalarShare> scalars(pixelsOf(tile), {none, 0.0});
  std::atomic<std::int64_t> samples = 0;
  const auto find = [&](const cpu::Strip& strip) {
    samples += cpu::findScalars(m_terms, strip.y, strip.fromX, strip.toX, &scalars[strip.inTile]);
  };
  cpu::forEachStrip(tile, intersection(tile, m_covered), m_threads, find, m_isCancelled);
  m_samples += samples;
  return scalars;
}

Image BrickRenderer::classified(const PixelRect& tile, const std::vector<ScalarShare>& folded) const {
  Image image(tile.size);
  if (m_plan.isVisible)
    cpu::classifyScalars(m_terms, folded.data(), pixelsOf(tile), image.pixels.data());
  return image;
}

void foldOver(const glm::vec4* front, glm::vec4* back, std::size_t pixels) {
  for (std::size_t i = 0; i < pixels; ++i)
    back[i] = front[i] + (1.0f - front[i].a) * back[i];
}

} // namespace limn
