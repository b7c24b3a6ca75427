// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/mpi/SharedDrawing.h"

#include <algorithm>
#include <fstream>

namespace limn {

Image SharedDrawing::draw(const std::function<Scene()>& scene, const glm::ivec2& size) {
  std::vector<int> order;
  m_ranks.agree(failureOf([&] {
    const Scene drawn = scene();
    requireDrawable(drawn);
    const Grid& grid = drawn.volume->grid();
    const Bricks bricks(grid, drawn.crop, m_ranks.count());
    order = bricks.frontToBack(rayFrame(drawn.camera, grid, size));
    m_renderer.begin(drawn, size, bricks.box(m_ranks.rank()));
  }));
  const RanksInOrder inOrder(m_ranks, order);
  Image picture(m_ranks.isFirst() ? size : glm::ivec2(0));
  constexpr int rows = 128;
  for (int y = 0; y < size.y; y += rows)
    drawStrip({{0, y}, {size.x, std::min(rows, size.y - y)}}, inOrder, picture);
  return picture;
}

// What may fail on a rank is agreed on before the others wait for its part.
void SharedDrawing::drawStrip(const PixelRect& strip, const RanksInOrder& inOrder, Image& picture) {
  if (m_renderer.folding() != Folding::over)
    return foldScalars(strip, picture);
  SurfaceHits hits;
  if (m_renderer.hasSurface()) {
    m_ranks.agree(failureOf([&] { hits.own = hits.nearest = m_renderer.hits(strip); }));
    m_ranks.smallest(hits.nearest);
    m_cost.foldedBytes += static_cast<double>(hits.own.size() * sizeof(float));
  }
  Image share;
  m_ranks.agree(failureOf([&] { share = m_renderer.share(strip, hits); }));
  inOrder.over(share.pixels, m_ranks.isFirst() ? &picture.at(0, strip.topLeft.y) : nullptr);
  m_cost.foldedBytes += static_cast<double>(share.pixels.size() * sizeof(glm::vec4));
  noteMemory();
}

void SharedDrawing::foldScalars(const PixelRect& strip, Image& picture) {
  std::vector<ScalarShare> shares;
  m_ranks.agree(failureOf([&] { shares = m_renderer.scalars(strip); }));
  const std::vector<ScalarShare> folded = m_ranks.folded(shares, m_renderer.folding());
  m_cost.foldedBytes += static_cast<double>(shares.size() * sizeof(ScalarShare));
  if (m_ranks.isFirst())
    std::ranges::copy(m_renderer.classified(strip, folded).pixels, &picture.at(0, strip.topLeft.y));
  noteMemory();
}

void SharedDrawing::noteMemory() {
  m_cost.samples = static_cast<double>(m_renderer.samples());
  m_cost.ownMb = std::max(m_cost.ownMb, ownMemoryMb());
}

double ownMemoryMb() {
  std::ifstream status("/proc/self/status");
  std::string word;
  double kilobytes = 0.0;
  while (status >> word)
    if (word == "RssAnon:" && status >> kilobytes)
      return kilobytes * 1024.0 / 1e6;
  return 0.0;
}

} // namespace limn
