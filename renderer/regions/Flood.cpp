// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/Flood.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <bit>
#include <deque>
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

constexpr int topBit = BitGrid::wordBits - 1;

// Grows the bits of a row along it, as far as `allowed` goes without a gap, in steps that double their reach;
// upwards, then downwards. Returns whether any bit was added.
bool floodRow(Word* grown, const Word* allowed, int words) {
  bool isChanged = false;
  Word carry = 0;
  for (int w = 0; w < words; ++w) {
    Word open = allowed[w], now = grown[w] | (carry & open);
    for (int step = 1; step < BitGrid::wordBits; step *= 2) {
      now |= open & now << step;
      open &= open << step;
    }
    isChanged |= now != grown[w];
    grown[w] = now;
    carry = now >> topBit;
  }
  carry = 0;
  for (int w = words - 1; w >= 0; --w) {
    Word open = allowed[w], now = grown[w] | (carry & open);
    for (int step = 1; step < BitGrid::wordBits; step *= 2) {
      now |= open & now >> step;
      open &= open >> step;
    }
    isChanged |= now != grown[w];
    grown[w] = now;
    carry = now << topBit;
  }
  return isChanged;
}

// Adds to a row what the rows around it pass on. Returns whether it has more voxels now.
bool takeFromRowsAround(BitGrid& grown, const BitGrid& allowed, int y, int z) {
  const glm::ivec3& dims = grown.dims();
  const int words = grown.rowWords();
  Word* row = grown.row(y, z);
  const Word* free = allowed.row(y, z);
  bool isChanged = false;
  for (int k = std::max(0, z - 1); k <= std::min(dims.z - 1, z + 1); ++k)
    for (int j = std::max(0, y - 1); j <= std::min(dims.y - 1, y + 1); ++j) {
      const Word* near = grown.row(j, k);
      for (int w = 0; w < words; ++w) {
        const Word below = w > 0 ? near[w - 1] >> topBit : 0;
        const Word above = w + 1 < words ? near[w + 1] << topBit : 0;
        const Word wide = near[w] | near[w] << 1 | below | near[w] >> 1 | above;
        const Word more = wide & free[w] & ~row[w];
        isChanged |= more != 0;
        row[w] |= more;
      }
    }
  return isChanged;
}

// The rows of a grid that are to be looked at (again), each at most once at a time.
class RowsToVisit {
public:
  explicit RowsToVisit(const glm::ivec3& dims)
      : m_dims(dims), m_waits(static_cast<std::size_t>(dims.y) * dims.z, true) {
    for (std::size_t n = 0; n < m_waits.size(); ++n)
      m_rows.push_back(n);
  }

  bool empty() const { return m_rows.empty(); }

  glm::ivec2 next() {
    const std::size_t n = m_rows.front();
    m_rows.pop_front();
    m_waits[n] = false;
    return {static_cast<int>(n % m_dims.y), static_cast<int>(n / m_dims.y)};
  }

  void addAround(int y, int z) {
    for (int k = std::max(0, z - 1); k <= std::min(m_dims.z - 1, z + 1); ++k)
      for (int j = std::max(0, y - 1); j <= std::min(m_dims.y - 1, y + 1); ++j) {
        const std::size_t n = static_cast<std::size_t>(k) * m_dims.y + j;
        if (m_waits[n] || (j == y && k == z))
          continue;
        m_waits[n] = true;
        m_rows.push_back(n);
      }
  }

private:
  glm::ivec3 m_dims;
  std::vector<bool> m_waits;
  std::deque<std::size_t> m_rows;
};

// A slice as rows of words: `count` rows, `stride` words apart, from `first` on.
struct Slice {
  const Word* set = nullptr;
  int count = 0;
  std::size_t stride = 0;
};

// The bits of word `w` of a row outside the set.
Word outside(const BitGrid& grid, const Slice& slice, int row, int w) {
  return ~slice.set[row * slice.stride + w] & grid.voxelsOfWord(w);
}

// What can be left within a slice of rows, row after row.
std::vector<Word> leavable(const BitGrid& grid, const Slice& slice) {
  const int words = grid.rowWords();
  std::vector<Word> free(static_cast<std::size_t>(slice.count) * words), reached(free.size());
  for (int n = 0; n < slice.count; ++n)
    for (int w = 0; w < words; ++w)
      free[n * words + w] = outside(grid, slice, n, w);
  const Word firstBit = 1, lastBit = Word{1} << ((grid.dims().x - 1) % BitGrid::wordBits);
  for (int n = 0; n < slice.count; ++n) {
    const bool isEdge = n == 0 || n == slice.count - 1;
    for (int w = 0; w < words; ++w)
      reached[n * words + w] = free[n * words + w] &
                               (isEdge ? ~Word{0} : (w == 0 ? firstBit : 0) | (w == words - 1 ? lastBit : 0));
  }
  const auto visit = [&](int n, int from) {
    Word* row = &reached[static_cast<std::size_t>(n) * words];
    const Word* near = &reached[static_cast<std::size_t>(from) * words];
    const Word* open = &free[static_cast<std::size_t>(n) * words];
    bool isChanged = false;
    for (int w = 0; w < words; ++w) {
      const Word more = near[w] & open[w] & ~row[w];
      isChanged |= more != 0;
      row[w] |= more;
    }
    return floodRow(row, open, words) || isChanged;
  };
  for (bool isChanged = true; isChanged;) {
    isChanged = false;
    for (int n = 0; n < slice.count; ++n)
      isChanged |= visit(n, std::max(0, n - 1));
    for (int n = slice.count - 1; n >= 0; --n)
      isChanged |= visit(n, std::min(slice.count - 1, n + 1));
  }
  return reached;
}

// Fills a slice of rows, which is given by its first row in the set.
void fillRows(BitGrid& set, Word* first, int count, std::size_t stride) {
  const std::vector<Word> reached = leavable(set, {first, count, stride});
  for (int n = 0; n < count; ++n)
    for (int w = 0; w < set.rowWords(); ++w)
      first[n * stride + w] =
          ~reached[static_cast<std::size_t>(n) * set.rowWords() + w] & set.voxelsOfWord(w);
}

// Fills the 64 slices across x that share a word: each bit is a slice of its own.
void fillWord(BitGrid& set, int w) {
  const int rows = set.dims().y, slices = set.dims().z;
  std::vector<Word> reached(static_cast<std::size_t>(rows) * slices);
  const auto at = [rows](int y, int z) { return static_cast<std::size_t>(z) * rows + y; };
  const auto take = [&](int y, int z, Word near, bool& isChanged) {
    const Word more = near & ~set.row(y, z)[w] & ~reached[at(y, z)];
    isChanged |= more != 0;
    reached[at(y, z)] |= more;
  };
  for (bool isChanged = true; isChanged;) {
    isChanged = false;
    for (int z = 0; z < slices; ++z)
      for (int y = 0; y < rows; ++y)
        take(y, z, y == 0 || z == 0 ? ~Word{0} : reached[at(y - 1, z)] | reached[at(y, z - 1)], isChanged);
    for (int z = slices - 1; z >= 0; --z)
      for (int y = rows - 1; y >= 0; --y)
        take(y, z,
             y == rows - 1 || z == slices - 1 ? ~Word{0} : reached[at(y + 1, z)] | reached[at(y, z + 1)],
             isChanged);
  }
  for (int z = 0; z < slices; ++z)
    for (int y = 0; y < rows; ++y)
      set.row(y, z)[w] = ~reached[at(y, z)] & set.voxelsOfWord(w);
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

BitGrid grownWithin(const BitGrid& seeds, const BitGrid& allowed, const Effort& effort) {
  BitGrid grown = seeds, open = allowed;
  open |= seeds;
  RowsToVisit rows(seeds.dims());
  constexpr int visitsBetweenLooks = 4096;
  for (int visits = 0; !rows.empty(); ++visits) {
    if (visits % visitsBetweenLooks == 0 && effort.isCancelled && effort.isCancelled())
      throw Cancelled();
    const glm::ivec2 row = rows.next();
    bool isChanged = takeFromRowsAround(grown, open, row.x, row.y);
    isChanged |= floodRow(grown.row(row.x, row.y), open.row(row.x, row.y), grown.rowWords());
    if (isChanged)
      rows.addAround(row.x, row.y);
  }
  return grown;
}

BitGrid withHolesFilled(const BitGrid& set, const Effort& effort) {
  BitGrid filled = set;
  const glm::ivec3& dims = set.dims();
  const auto rowWords = static_cast<std::size_t>(set.rowWords());
  forEachPiece(dims.z, partOf(effort, 0.0, 0.3),
               [&](int z) { fillRows(filled, filled.row(0, z), dims.y, rowWords); });
  forEachPiece(dims.y, partOf(effort, 0.3, 0.6),
               [&](int y) { fillRows(filled, filled.row(y, 0), dims.z, rowWords * dims.y); });
  forEachPiece(set.rowWords(), partOf(effort, 0.6, 1.0), [&](int w) { fillWord(filled, w); });
  return filled;
}

} // namespace limn
