// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/mpi/SharedDrawing.h"

#include "app/core/drawing/ProcessCost.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace limn {
namespace {

static_assert(sizeof(glm::vec4) == 4 * sizeof(float));

// `front` are the pixels of lower ranks.
void putOver(void* front, void* back, int* pixels, MPI_Datatype*) {
  foldOver(static_cast<const glm::vec4*>(front), static_cast<glm::vec4*>(back),
           static_cast<std::size_t>(*pixels));
}

} // namespace

RanksInOrder::RanksInOrder(const Ranks& ranks, const std::vector<int>& order) {
  const auto placeOf = [&](int rank) {
    return static_cast<int>(std::ranges::find(order, rank) - order.begin());
  };
  m_first = placeOf(0);
  MPI_Comm_split(MPI_COMM_WORLD, 0, placeOf(ranks.rank()), &m_ranks);
  MPI_Type_contiguous(4, MPI_FLOAT, &m_pixel);
  MPI_Type_commit(&m_pixel);
  constexpr int commutes = 0;
  MPI_Op_create(putOver, commutes, &m_over);
}

RanksInOrder::~RanksInOrder() {
  MPI_Op_free(&m_over);
  MPI_Type_free(&m_pixel);
  MPI_Comm_free(&m_ranks);
}

void RanksInOrder::over(const std::vector<glm::vec4>& share, glm::vec4* folded) const {
  MPI_Reduce(share.data(), folded, static_cast<int>(share.size()), m_pixel, m_over, m_first, m_ranks);
}

SharedDrawing::SharedDrawing(const Ranks& ranks, int threads)
    : m_ranks(ranks), m_facts(ranks, threads), m_renderer(threads) {
  forgetPeak();
  m_startMb = residentMb();
}

// The scene's volume with what this rank reads of it held.
std::shared_ptr<const Volume> SharedDrawing::holding(const Scene& scene, const IndexBox& brick) {
  const VoxelBox needed = voxelsRead(scene.volume->grid(), brick, scene.quality.stepVoxels);
  if (!scene.volume->part() || contains(scene.volume->part()->box, needed))
    return scene.volume;
  if (!m_reread || (m_reread->part() && !contains(m_reread->part()->box, needed))) {
    m_reread.reset();
    m_reread = reread(*scene.volume, needed);
  }
  return m_reread;
}

Image SharedDrawing::draw(const std::function<Scene()>& scene, const glm::ivec2& size) {
  std::vector<int> order;
  Scene drawn;
  IndexBox brick;
  m_ranks.agree(failureOf([&] {
    drawn = scene();
    requireDrawable(drawn);
    const Grid& grid = drawn.volume->grid();
    const bool inSlices = drawn.volume->part() && drawn.volume->part()->isInSlices;
    const Bricks bricks(grid, drawn.crop, m_ranks.count(), inSlices);
    order = bricks.frontToBack(rayFrame(drawn.camera, grid, size));
    brick = bricks.box(m_ranks.rank());
  }));
  const WholeFacts whole = m_facts.of(drawn);
  m_ranks.agree(failureOf([&] {
    drawn.volume = holding(drawn, brick);
    m_renderer.setWhole(whole);
    m_renderer.begin(drawn, size, brick);
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
  m_cost.addedMb = peakResidentMb() - m_startMb;
}

double bytesRead() {
  std::ifstream counts("/proc/self/io");
  std::string word;
  double bytes = 0.0;
  while (counts >> word)
    if (word == "rchar:" && counts >> bytes)
      return bytes;
  return 0.0;
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
