// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/mpi/SharedDrawing.h"

#include <algorithm>
#include <fstream>
#include <new>

namespace limn {
namespace {

static_assert(sizeof(glm::vec4) == 4 * sizeof(float) && sizeof(ScalarShare) == 2 * sizeof(double));

// `front` are the pixels of lower ranks.
void putOver(void* front, void* back, int* pixels, MPI_Datatype*) {
  foldOver(static_cast<const glm::vec4*>(front), static_cast<glm::vec4*>(back),
           static_cast<std::size_t>(*pixels));
}

// What MPI counts with an int: strips of pictures are far smaller.
int asCount(std::size_t size) {
  return static_cast<int>(size);
}

} // namespace

Ranks::Ranks(int& argc, char**& argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &m_rank);
  MPI_Comm_size(MPI_COMM_WORLD, &m_count);
}

Ranks::~Ranks() {
  MPI_Finalize();
}

int Ranks::onThisMachine() const {
  MPI_Comm machine = MPI_COMM_NULL;
  MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
  int count = 1;
  MPI_Comm_size(machine, &count);
  MPI_Comm_free(&machine);
  return count;
}

std::string Ranks::fromFirst(const std::string& text) const {
  std::string received = text;
  int size = asCount(received.size());
  MPI_Bcast(&size, 1, MPI_INT, 0, MPI_COMM_WORLD);
  received.resize(static_cast<std::size_t>(size));
  MPI_Bcast(received.data(), size, MPI_CHAR, 0, MPI_COMM_WORLD);
  return received;
}

void Ranks::agree(const std::optional<Error>& failure) const {
  const int mine = failure ? m_rank : m_count;
  int failed = m_count;
  MPI_Allreduce(&mine, &failed, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  if (failed == m_count)
    return;
  std::string sentence = failed == m_rank ? failure->what() : "";
  int said[2] = {asCount(sentence.size()), failed == m_rank ? static_cast<int>(failure->kind()) : 0};
  MPI_Bcast(said, 2, MPI_INT, failed, MPI_COMM_WORLD);
  sentence.resize(static_cast<std::size_t>(said[0]));
  MPI_Bcast(sentence.data(), said[0], MPI_CHAR, failed, MPI_COMM_WORLD);
  throw Error(static_cast<Error::Kind>(said[1]), Message(sentence));
}

void Ranks::smallest(std::vector<float>& values) const {
  MPI_Allreduce(MPI_IN_PLACE, values.data(), asCount(values.size()), MPI_FLOAT, MPI_MIN, MPI_COMM_WORLD);
}

std::vector<ScalarShare> Ranks::folded(const std::vector<ScalarShare>& shares, Folding folding) const {
  std::vector<ScalarShare> result(isFirst() ? shares.size() : 0);
  MPI_Reduce(shares.data(), result.data(), asCount(2 * shares.size()), MPI_DOUBLE,
             folding == Folding::sum ? MPI_SUM : MPI_MAX, 0, MPI_COMM_WORLD);
  return result;
}

std::vector<double> Ranks::gathered(const std::vector<double>& numbers) const {
  std::vector<double> all(isFirst() ? numbers.size() * static_cast<std::size_t>(m_count) : 0);
  MPI_Gather(numbers.data(), asCount(numbers.size()), MPI_DOUBLE, all.data(), asCount(numbers.size()),
             MPI_DOUBLE, 0, MPI_COMM_WORLD);
  return all;
}

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
  MPI_Reduce(share.data(), folded, asCount(share.size()), m_pixel, m_over, m_first, m_ranks);
}

std::optional<Error> failureOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return Error(Error::Kind::other, "There is not enough memory on a rank for its part of the picture; use "
                                     "more machines, fewer ranks on each, or a smaller picture.");
  } catch (const std::exception& error) {
    return Error(Error::Kind::other, Message(std::string("Something unexpected failed on a rank: ") +
                                             error.what() + ". Please report it with `limn info --system`."));
  }
  return std::nullopt;
}

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
