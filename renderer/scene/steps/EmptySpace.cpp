// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/EmptySpace.h"

#include "scene/basics/Error.h"
#include "scene/volume/Volume.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <limits>
#include <mutex>

// Distances are made axis by axis: along rows, then from row to row, then from plane to plane. On the way
// from one row or plane to the next a block takes one more than the least of its neighbours there. That is
// exact, because distances within a row or plane differ by at most one from block to block: whoever needs to
// go farther sideways than ahead has gone so before. All loops are over rows of bytes without order.

namespace limn {
namespace {

std::uint8_t plus(std::uint8_t distance, std::uint8_t more) {
  return static_cast<std::uint8_t>(std::min<std::uint8_t>(distance, farthestBlock - more) + more);
}

// A row of distances between margins of `farthestBlock`.
class PaddedRow {
public:
  explicit PaddedRow(int size) : m_bytes(static_cast<std::size_t>(size) + 2 * margin, farthestBlock) {}
  std::uint8_t* begin() { return m_bytes.data() + margin; }

private:
  static constexpr std::size_t margin = 128;
  std::vector<std::uint8_t> m_bytes;
};

void takeNearer(const std::uint8_t* from, int size, int step, std::uint8_t* to) {
  for (int i = 0; i < size; ++i)
    to[i] =
        std::min(from[i], plus(std::min(from[i - step], from[i + step]), static_cast<std::uint8_t>(step)));
}

// From 0 and `farthestBlock` to distances along the row, in strides of 1, 2, 4, … blocks.
void spreadAlongRow(std::uint8_t* row, int size, PaddedRow& from, PaddedRow& to) {
  const bool isAlike = std::memcmp(row, row + 1, static_cast<std::size_t>(size) - 1) == 0;
  if (isAlike)
    return;
  PaddedRow* now = &from;
  PaddedRow* next = &to;
  std::copy_n(row, size, now->begin());
  for (int step = 1; step < std::min(size, 256); step *= 2) {
    takeNearer(now->begin(), size, step, next->begin());
    std::swap(now, next);
  }
  std::copy_n(now->begin(), size, row);
}

// Writes the least of each element of a row and its neighbours.
void leastOfThree(const std::uint8_t* from, int size, std::uint8_t* to) {
  if (size == 1) {
    to[0] = from[0];
    return;
  }
  to[0] = std::min(from[0], from[1]);
  for (int i = 1; i + 1 < size; ++i)
    to[i] = std::min(from[i], std::min(from[i - 1], from[i + 1]));
  to[size - 1] = std::min(from[size - 2], from[size - 1]);
}

// Lowers each element of a row to one more than the least of three beside it.
void lowerToNeighbours(const std::uint8_t* beside, int size, std::uint8_t* row) {
  if (size == 1) {
    row[0] = std::min(row[0], plus(beside[0], 1));
    return;
  }
  row[0] = std::min(row[0], plus(std::min(beside[0], beside[1]), 1));
  for (int i = 1; i + 1 < size; ++i)
    row[i] = std::min(row[i], plus(std::min(beside[i], std::min(beside[i - 1], beside[i + 1])), 1));
  row[size - 1] = std::min(row[size - 1], plus(std::min(beside[size - 2], beside[size - 1]), 1));
}

void lowerTo(const std::uint8_t* a, const std::uint8_t* b, const std::uint8_t* c, int size,
             std::uint8_t* row) {
  for (int i = 0; i < size; ++i)
    row[i] = std::min(row[i], plus(std::min(a[i], std::min(b[i], c[i])), 1));
}

// By this much of the volume's range may a filtered texel leave the range of its neighbours.
constexpr float textureRounding = 1e-5f;

// A filter rounds: by this much of a bin may a sample fall into the neighbouring one.
constexpr float binMargin = 0.01f;

constexpr float beyondAll = std::numeric_limits<float>::infinity();

// Scalars that show: a block does whose highest scalar is `first` or more and whose lowest is `last` or less.
struct VisibleRun {
  float first = -beyondAll;
  float last = beyondAll;
};

// Floats in ascending order as numbers in ascending order.
std::uint32_t orderOf(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return (bits & 0x80000000u) != 0 ? ~bits : bits | 0x80000000u;
}

float valueAt(std::uint32_t order) {
  return std::bit_cast<float>((order & 0x80000000u) != 0 ? order & 0x7fffffffu : ~order);
}

// The smallest float of which `holds` is true; of larger ones it must be, too.
template <class Predicate>
float firstThat(Predicate&& holds) {
  std::uint32_t below = orderOf(-beyondAll);
  std::uint32_t found = orderOf(beyondAll);
  while (found - below > 1) {
    const std::uint32_t middle = below + (found - below) / 2;
    (holds(valueAt(middle)) ? found : below) = middle;
  }
  return valueAt(found);
}

// The runs of bins that hold an opacity. The first and the last bin have no outer end.
std::vector<VisibleRun> runsOf(const PiecewiseTable& function) {
  const auto placeOf = [domain = function.domain](float scalar) { return (scalar - domain.x) * domain.y; };
  const auto isVisible = [&](std::size_t bin) { return function.occupancy[bin].x > 0.0f; };
  const std::size_t bins = function.occupancy.size();
  std::vector<VisibleRun> runs;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    if (!isVisible(bin))
      continue;
    VisibleRun run;
    const auto begin = static_cast<float>(bin);
    if (bin > 0)
      run.first = firstThat([&](float scalar) { return placeOf(scalar) + binMargin >= begin; });
    while (bin + 1 < bins && isVisible(bin + 1))
      ++bin;
    const auto end = static_cast<float>(bin + 1);
    if (bin + 1 < bins)
      run.last = std::nextafter(firstThat([&](float scalar) { return !(placeOf(scalar) - binMargin < end); }),
                                -beyondAll);
    runs.push_back(run);
  }
  return runs;
}

// In ascending order, those that overlap as one.
std::vector<VisibleRun> runsOf(const PiecewiseTable* function, const std::optional<float>& isovalue) {
  std::vector<VisibleRun> runs;
  if (function)
    runs = runsOf(*function);
  if (isovalue)
    // A ray that enters the volume at or above the isovalue is hit where it enters, so a block beyond it is
    // not empty; no ray goes on behind one.
    runs.push_back({firstThat([&](float scalar) { return *isovalue <= scalar + textureRounding; })});
  std::sort(runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<VisibleRun> apart;
  for (const VisibleRun& run : runs)
    if (!apart.empty() && run.first <= apart.back().last)
      apart.back().last = std::max(apart.back().last, run.last);
    else
      apart.push_back(run);
  return apart;
}

// The blocks of which something may show, of some.
struct Census {
  std::int64_t occupied = 0;
  BlockBox box{glm::ivec3(std::numeric_limits<int>::max()), glm::ivec3(0)};

  // Counts a row of 0 and `farthestBlock`.
  void addRow(const std::uint8_t* row, int size, int j, int k) {
    const auto* first = static_cast<const std::uint8_t*>(std::memchr(row, 0, static_cast<std::size_t>(size)));
    if (!first)
      return;
    const std::uint8_t* end = row + size;
    while (end[-1] != 0)
      --end;
    int empty = 0;
    for (const std::uint8_t* block = first; block != end; ++block)
      empty += *block & 1;
    occupied += end - first - empty;
    box.lower = glm::min(box.lower, glm::ivec3(first - row, j, k));
    box.upper = glm::max(box.upper, glm::ivec3(end - row, j + 1, k + 1));
  }

  void add(const Census& other) {
    box = {glm::min(box.lower, other.box.lower), glm::max(box.upper, other.box.upper)};
    occupied += other.occupied;
  }
};

// Which of the blocks of a group show: 0 for those that may, otherwise `farthestBlock`.
using Flags = std::array<std::uint8_t, BlockRanges::Group::size>;

Flags flagsOf(const BlockRanges::Group& group, const VisibleRun* begin, const VisibleRun* end) {
  Flags flags;
  flags.fill(farthestBlock);
  for (const VisibleRun* run = begin; run != end; ++run)
    for (std::size_t i = 0; i < flags.size(); ++i) {
      const bool isOutside = int(group.highest[i] < run->first) | int(group.lowest[i] > run->last);
      flags[i] = isOutside ? flags[i] : std::uint8_t{0};
    }
  return flags;
}

Flags flagsOf(const BlockRanges& ranges, const std::vector<VisibleRun>& runs, const glm::ivec3& group) {
  const glm::vec2& all = ranges.groupRange(group.x, group.y, group.z);
  const auto begin = std::lower_bound(runs.begin(), runs.end(), all.x,
                                      [](const VisibleRun& run, float lowest) { return run.last < lowest; });
  auto end = begin;
  while (end != runs.end() && end->first <= all.y)
    ++end;
  if (begin != end && begin->first <= all.x && begin->last >= all.y) { // around every block
    Flags flags;
    flags.fill(0);
    return flags;
  }
  return flagsOf(ranges.group(group.x, group.y, group.z), runs.data() + (begin - runs.begin()),
                 runs.data() + (end - runs.begin()));
}

// What shows of a picture: the runs of its function, or of the function of each look.
struct Showing {
  std::vector<std::vector<VisibleRun>> runs;
  const BlockWeights& weights;
  const BlockLooks* blockLooks;
};

Showing showingOf(const Visibility& visibility, const BlockWeights& all) {
  Showing showing{
      {}, visibility.weights ? *visibility.weights : all, visibility.looks ? visibility.blockLooks : nullptr};
  if (!visibility.looks)
    showing.runs.push_back(runsOf(visibility.function, visibility.isovalue));
  else
    for (const PiecewiseTable& look : *visibility.looks)
      showing.runs.push_back(runsOf(&look, visibility.isovalue));
  return showing;
}

// Of a group of blocks of several looks: each shows what one of its own looks shows.
Flags flagsOfLooks(const BlockRanges& ranges, const Showing& showing, const glm::ivec3& group) {
  std::array<LookBits, BlockRanges::Group::size> bits{};
  LookBits any = 0;
  const glm::ivec3& blocks = ranges.blocks();
  const glm::ivec3 first = group * groupSize;
  const glm::ivec3 count = glm::min(glm::ivec3(groupSize), blocks - first);
  for (int k = 0; k < count.z; ++k)
    for (int j = 0; j < count.y; ++j)
      for (int i = 0; i < count.x; ++i) {
        const LookBits own =
            (*showing.blockLooks)[voxelOffset(blocks, first.x + i, first.y + j, first.z + k)];
        bits[voxelOffset(glm::ivec3(groupSize), i, j, k)] = own;
        any |= own;
      }
  Flags flags;
  flags.fill(farthestBlock);
  for (; any != 0; any &= any - 1) {
    const int look = std::countr_zero(any);
    const Flags own = flagsOf(ranges, showing.runs[static_cast<std::size_t>(look)], group);
    for (std::size_t i = 0; i < flags.size(); ++i)
      if ((bits[i] >> look & 1) != 0)
        flags[i] = std::min(flags[i], own[i]);
  }
  return flags;
}

// Classifies the blocks of a row of groups.
void classifyGroups(const BlockRanges& ranges, const Showing& showing, int groupY, int groupZ,
                    BlockDistances& distances, Census& census) {
  const BlockWeights& weights = showing.weights;
  const glm::ivec3& blocks = ranges.blocks();
  const glm::ivec2 first = glm::ivec2(groupY, groupZ) * groupSize;
  const glm::ivec2 count = glm::min(glm::ivec2(groupSize), glm::ivec2(blocks.y, blocks.z) - first);
  for (int i = 0; i < ranges.groups().x; ++i) {
    const glm::ivec3 group(i, groupY, groupZ);
    const Flags flags = showing.blockLooks ? flagsOfLooks(ranges, showing, group)
                                           : flagsOf(ranges, showing.runs.front(), group);
    const int width = std::min(groupSize, blocks.x - i * groupSize);
    for (int k = 0; k < count.y; ++k)
      for (int j = 0; j < count.x; ++j) {
        std::uint8_t* to = &distances[voxelOffset(blocks, i * groupSize, first.x + j, first.y + k)];
        const std::uint8_t* from = &flags[voxelOffset(glm::ivec3(groupSize), 0, j, k)];
        if (width == groupSize)
          std::memcpy(to, from, groupSize);
        else
          std::copy_n(from, width, to);
      }
  }
  for (int k = first.y; k < first.y + count.y; ++k)
    for (int j = first.x; j < first.x + count.x; ++j) {
      const std::size_t row = voxelOffset(blocks, 0, j, k);
      if (!weights.empty())
        for (std::size_t i = row; i < row + static_cast<std::size_t>(blocks.x); ++i)
          distances[i] = weights[i] == BlockWeight::none ? farthestBlock : distances[i];
      census.addRow(&distances[row], blocks.x, j, k);
    }
}

} // namespace

void spreadWithinPlanes(const glm::ivec3& blocks, int first, int end, BlockDistances& distances) {
  PaddedRow from(blocks.x), to(blocks.x);
  for (int k = first; k < end; ++k) {
    const auto rowAt = [&](int j) { return &distances[voxelOffset(blocks, 0, j, k)]; };
    for (int j = 0; j < blocks.y; ++j)
      spreadAlongRow(rowAt(j), blocks.x, from, to);
    for (int j = 0; j + 1 < blocks.y; ++j)
      lowerToNeighbours(rowAt(j), blocks.x, rowAt(j + 1));
    for (int j = blocks.y - 1; j > 0; --j)
      lowerToNeighbours(rowAt(j), blocks.x, rowAt(j - 1));
  }
}

void spreadAcrossPlanes(const glm::ivec3& blocks, BlockDistances& distances, const Effort& effort) {
  std::vector<std::uint8_t> threes(static_cast<std::size_t>(blocks.x) * blocks.y);
  const auto step = [&](int k, int next) {
    if (effort.isCancelled && effort.isCancelled())
      throw Cancelled();
    const auto threesAt = [&](int j) { return &threes[voxelOffset(blocks, 0, j, 0)]; };
    for (int j = 0; j < blocks.y; ++j)
      leastOfThree(&distances[voxelOffset(blocks, 0, j, k)], blocks.x, threesAt(j));
    for (int j = 0; j < blocks.y; ++j)
      lowerTo(threesAt(std::max(0, j - 1)), threesAt(j), threesAt(std::min(blocks.y - 1, j + 1)), blocks.x,
              &distances[voxelOffset(blocks, 0, j, next)]);
  };
  for (int k = 0; k + 1 < blocks.z; ++k)
    step(k, k + 1);
  for (int k = blocks.z - 1; k > 0; --k)
    step(k, k - 1);
}

void spreadDistances(const glm::ivec3& blocks, BlockDistances& distances, const Effort& effort) {
  forEachPiece(blocks.z, effort, [&](int k) { spreadWithinPlanes(blocks, k, k + 1, distances); });
  spreadAcrossPlanes(blocks, distances, effort);
}

void mapEmptySpace(const BlockRanges& ranges, const Visibility& visibility, EmptySpaceMap& map,
                   const Effort& effort) {
  const glm::ivec3& blocks = ranges.blocks();
  map.distances.resize(static_cast<std::size_t>(blocks.x) * blocks.y * blocks.z);
  const BlockWeights all;
  const Showing showing = showingOf(visibility, all);
  Census census;
  std::mutex mutex;
  forEachPiece(ranges.groups().z, effort, [&](int k) {
    Census own;
    for (int j = 0; j < ranges.groups().y; ++j)
      classifyGroups(ranges, showing, j, k, map.distances, own);
    spreadWithinPlanes(blocks, k * groupSize, std::min((k + 1) * groupSize, blocks.z), map.distances);
    const std::lock_guard lock(mutex);
    census.add(own);
  });
  spreadAcrossPlanes(blocks, map.distances, effort);
  map.emptyShare = 1.0 - static_cast<double>(census.occupied) / static_cast<double>(map.distances.size());
  map.visible = census.occupied > 0 ? census.box : BlockBox{};
}

} // namespace limn
