// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/Flood.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <deque>
#include <vector>

namespace limn {
namespace {

using Word = BitGrid::Word;
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
