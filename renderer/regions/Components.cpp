// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/Components.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <vector>

namespace limn {
namespace {

using Word = BitGrid::Word;

// Neighbouring voxels of the set in one row, both ends included.
struct Run {
  int first = 0;
  int last = 0;
};

// The runs of all rows, x fastest, and where those of each row begin.
struct Runs {
  std::vector<Run> all;
  std::vector<std::uint32_t> begin; // of each row, and the end of the last
};

void appendRuns(const Word* row, int words, std::vector<Run>& runs) {
  bool isInside = false;
  for (int w = 0; w < words; ++w)
    for (int bit = 0; bit < BitGrid::wordBits;) {
      // The next bit that differs from those before it.
      const Word rest = (isInside ? ~row[w] : row[w]) >> bit;
      const int skip = rest == 0 ? BitGrid::wordBits - bit : std::countr_zero(rest);
      bit += skip;
      if (bit == BitGrid::wordBits)
        continue;
      const int x = w * BitGrid::wordBits + bit;
      if (isInside)
        runs.back().last = x - 1;
      else
        runs.push_back({x, words * BitGrid::wordBits - 1});
      isInside = !isInside;
    }
}

Runs runsOf(const BitGrid& set) {
  Runs runs;
  runs.begin.reserve(static_cast<std::size_t>(set.dims().y) * set.dims().z + 1);
  for (int z = 0; z < set.dims().z; ++z)
    for (int y = 0; y < set.dims().y; ++y) {
      runs.begin.push_back(static_cast<std::uint32_t>(runs.all.size()));
      appendRuns(set.row(y, z), set.rowWords(), runs.all);
    }
  runs.begin.push_back(static_cast<std::uint32_t>(runs.all.size()));
  return runs;
}

// Runs that are connected share a root.
class Forest {
public:
  explicit Forest(std::size_t size) : m_parent(size) { std::iota(m_parent.begin(), m_parent.end(), 0u); }

  std::uint32_t rootOf(std::uint32_t n) {
    while (m_parent[n] != n)
      n = m_parent[n] = m_parent[m_parent[n]];
    return n;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = rootOf(a);
    b = rootOf(b);
    m_parent[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::uint32_t> m_parent;
};

// Joins the runs of two neighbouring rows that overlap or touch at a corner.
void joinRows(const Runs& runs, std::size_t row, std::size_t other, Forest& forest) {
  std::uint32_t a = runs.begin[row], b = runs.begin[other];
  while (a < runs.begin[row + 1] && b < runs.begin[other + 1]) {
    const Run &left = runs.all[a], &right = runs.all[b];
    if (left.first <= right.last + 1 && right.first <= left.last + 1)
      forest.join(a, b);
    if (left.last < right.last)
      ++a;
    else
      ++b;
  }
}

void joinNeighbours(const Runs& runs, const glm::ivec3& dims, int z, Forest& forest) {
  for (int y = 0; y < dims.y; ++y) {
    const std::size_t row = static_cast<std::size_t>(z) * dims.y + y;
    if (y > 0)
      joinRows(runs, row, row - 1, forest);
    for (int near = std::max(0, y - 1); z > 0 && near <= std::min(dims.y - 1, y + 1); ++near)
      joinRows(runs, row, row - y - dims.y + near, forest);
  }
}

void setRun(Word* row, const Run& run) {
  const int first = run.first / BitGrid::wordBits, last = run.last / BitGrid::wordBits;
  for (int w = first; w <= last; ++w) {
    const Word from = w == first ? ~Word{0} << (run.first % BitGrid::wordBits) : ~Word{0};
    const Word to = w == last ? ~Word{0} >> (BitGrid::wordBits - 1 - run.last % BitGrid::wordBits) : ~Word{0};
    row[w] |= from & to;
  }
}

} // namespace

BitGrid largestComponent(const BitGrid& set, const Effort& effort) {
  const Runs runs = runsOf(set);
  Forest forest(runs.all.size());
  const Effort here{1, effort.isCancelled, effort.report};
  forEachPiece(set.dims().z, here, [&](int z) { joinNeighbours(runs, set.dims(), z, forest); });
  std::vector<std::size_t> voxels(runs.all.size(), 0);
  for (std::uint32_t n = 0; n < runs.all.size(); ++n)
    voxels[forest.rootOf(n)] += runs.all[n].last - runs.all[n].first + 1;
  BitGrid largest = set.emptyLike();
  if (voxels.empty())
    return largest;
  const auto root =
      static_cast<std::uint32_t>(std::max_element(voxels.begin(), voxels.end()) - voxels.begin());
  for (std::size_t row = 0; row + 1 < runs.begin.size(); ++row)
    for (std::uint32_t n = runs.begin[row]; n < runs.begin[row + 1]; ++n)
      if (forest.rootOf(n) == root)
        setRun(largest.row(static_cast<int>(row % set.dims().y), static_cast<int>(row / set.dims().y)),
               runs.all[n]);
  return largest;
}

} // namespace limn
