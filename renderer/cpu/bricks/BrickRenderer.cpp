// SPDX-License-Identifier: GPL-3.0-or-later
#include "cpu/bricks/BrickRenderer.h"

#include "cpu/Strips.h"
#include "cpu/simd/DrawRow.h"
#include "cpu/simd/InstructionSet.h"
#include "engine/CoveredPixels.h"
#include "engine/StepLimit.h"

#include <atomic>
#include <cassert>
#include <limits>
#include <thread>

namespace limn {
namespace {

std::size_t pixelsOf(const PixelRect& tile) {
  return static_cast<std::size_t>(tile.size.x) * static_cast<std::size_t>(tile.size.y);
}

int allOr(int threads) {
  return threads > 0 ? threads : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

} // namespace

BrickRenderer::BrickRenderer(int threads) : m_threads(allOr(threads)), m_data(m_threads, true) {
  cpu::requireInstructionSet();
}

void BrickRenderer::begin(const Scene& scene, const glm::ivec2& size, const IndexBox& brick,
                          const std::function<bool()>& isCancelled) {
  m_isCancelled = isCancelled;
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
