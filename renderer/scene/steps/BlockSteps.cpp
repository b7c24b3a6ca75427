// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/BlockSteps.h"

#include "scene/light/Gradient.h"
#include "scene/steps/LocalSteps.h"
#include "scene/volume/RowPieces.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

namespace limn {
namespace {

// In what the differences of stored numbers are computed: exactly, of 8 and 16 bits in float.
template <class T>
using Difference = std::conditional_t<sizeof(T) <= 2, float, double>;

// What a row of blocks along x gathers of the voxels on and in it, first for each place along x and then for
// each block: compilers make vector instructions of the loops over places.
template <class T>
class RowGatherer {
public:
  RowGatherer(const Volume& volume, const StoredVoxels<T>& stored)
      : m_stored(stored), m_dims(volume.grid().dims), m_spacing(volume.grid().spacingMm),
        m_rescale(volume.rescale()), m_smallest(smallestSpacingMm(volume.grid())),
        m_columns(static_cast<std::size_t>(m_dims.x)), m_padded(m_columns.lowest.size() + 2),
        m_rows(m_padded * perEdge * perEdge) {
    for (int axis = 0; axis < 3; ++axis) {
      const double share = m_smallest / m_spacing[axis];
      m_weight[axis] = static_cast<D>(share * share);
    }
  }

  /// Writes the facts of the blocks (0 … count-1, j, k).
  void gather(int j, int k, int count, FieldFacts* facts) {
    const glm::ivec2 first = glm::ivec2(j, k) * factCells;
    const glm::ivec2 last = glm::min(first + factCells, glm::ivec2(m_dims.y, m_dims.z) - 1);
    for (int z = first.y - 1; z <= last.y + 1; ++z)
      for (int y = first.x - 1; y <= last.x + 1; ++y)
        convert(y, z, rowAt(y - first.x, z - first.y));
    m_columns.clear();
    for (int z = first.y; z <= last.y; ++z)
      for (int y = first.x; y <= last.x; ++y)
        add(y - first.x, z - first.y, y < last.x, z < last.y);
    for (int i = 0; i < count; ++i)
      facts[i] = finished(i * factCells);
  }

private:
  using D = Difference<T>;

  static constexpr int perEdge = factCells + 3; // the voxels on the faces, and one beyond each

  // What is gathered at each place along x.
  struct Columns {
    explicit Columns(std::size_t size)
        : lowest(size), highest(size), alongX(size), alongY(size), alongZ(size), bend(size) {}

    void clear() {
      std::ranges::fill(lowest, std::numeric_limits<D>::infinity());
      std::ranges::fill(highest, -std::numeric_limits<D>::infinity());
      for (std::vector<D>* one : {&alongX, &alongY, &alongZ, &bend})
        std::ranges::fill(*one, D{0});
    }

    std::vector<D> lowest, highest;
    std::vector<D> alongX, alongY, alongZ; // the steepest change to the next voxel
    std::vector<D> bend;                   // squared, by the square of the smallest spacing
  };

  // Of the row of voxels beside the first one of the blocks.
  D* rowAt(int y, int z) {
    return &m_rows[static_cast<std::size_t>((z + 1) * perEdge + y + 1) * m_padded + 1];
  }

  // Beyond the outermost centres the field is constant.
  void convert(int y, int z, D* row) {
    const T* voxels =
        &m_stored[voxelOffset(m_dims, 0, std::clamp(y, 0, m_dims.y - 1), std::clamp(z, 0, m_dims.z - 1))];
    for (int x = 0; x < m_dims.x; ++x)
      row[x] = static_cast<D>(voxels[x]);
    row[-1] = row[0];
    row[m_dims.x] = row[m_dims.x - 1];
  }

  void add(int y, int z, bool hasNextY, bool hasNextZ) {
    const D* here = rowAt(y, z);
    const D* below = rowAt(y - 1, z);
    const D* above = rowAt(y + 1, z);
    const D* before = rowAt(y, z - 1);
    const D* behind = rowAt(y, z + 1);
    const D countsY = hasNextY ? D{1} : D{0}, countsZ = hasNextZ ? D{1} : D{0};
    const glm::vec<3, D> weight = m_weight;
    D* __restrict lowest = m_columns.lowest.data();
    D* __restrict highest = m_columns.highest.data();
    D* __restrict alongX = m_columns.alongX.data();
    D* __restrict alongY = m_columns.alongY.data();
    D* __restrict alongZ = m_columns.alongZ.data();
    D* __restrict bend = m_columns.bend.data();
    for (int x = 0; x < m_dims.x; ++x) {
      const D value = here[x];
      const D right = here[x + 1] - value, up = above[x] - value, on = behind[x] - value;
      const D bentX = (right - (value - here[x - 1])) * weight.x;
      const D bentY = (up - (value - below[x])) * weight.y;
      const D bentZ = (on - (value - before[x])) * weight.z;
      const D squares = bentX * bentX + bentY * bentY + bentZ * bentZ;
      lowest[x] = value < lowest[x] ? value : lowest[x];
      highest[x] = value > highest[x] ? value : highest[x];
      const D x1 = std::abs(right), y1 = std::abs(up) * countsY, z1 = std::abs(on) * countsZ;
      alongX[x] = x1 > alongX[x] ? x1 : alongX[x];
      alongY[x] = y1 > alongY[x] ? y1 : alongY[x];
      alongZ[x] = z1 > alongZ[x] ? z1 : alongZ[x];
      bend[x] = squares > bend[x] ? squares : bend[x];
    }
  }

  // Of the block whose first voxel is at x.
  FieldFacts finished(int x) const {
    const auto first = static_cast<std::size_t>(x);
    const auto last = static_cast<std::size_t>(std::min(x + factCells, m_dims.x - 1));
    D lowest = m_columns.lowest[first], highest = m_columns.highest[first], bend = m_columns.bend[first];
    glm::vec<3, D> steepest(0, m_columns.alongY[first], m_columns.alongZ[first]);
    for (std::size_t n = first + 1; n <= last; ++n) {
      lowest = std::min(lowest, m_columns.lowest[n]);
      highest = std::max(highest, m_columns.highest[n]);
      bend = std::max(bend, m_columns.bend[n]);
      steepest = glm::max(steepest, {m_columns.alongX[n - 1], m_columns.alongY[n], m_columns.alongZ[n]});
    }
    const double slope = std::abs(m_rescale.slope);
    const double a = m_rescale.slope * double(lowest) + m_rescale.intercept;
    const double b = m_rescale.slope * double(highest) + m_rescale.intercept;
    return {{std::min(a, b), std::max(a, b)},
            slope * glm::length(glm::dvec3(steepest) / m_spacing),
            slope * (std::sqrt(double(bend)) / (m_smallest * m_smallest))};
  }

  const StoredVoxels<T>& m_stored;
  glm::ivec3 m_dims;
  glm::dvec3 m_spacing;
  Rescale m_rescale;
  double m_smallest;
  glm::vec<3, D> m_weight; // of a second difference along each axis
  Columns m_columns;
  std::size_t m_padded; // voxels of a row with one more at each end
  std::vector<D> m_rows;
};

// Less of a peak or valley changes no channel by much more than a level in the blocks that it concerns.
constexpr double leastBand = 0.02;

// By this much of the volume's range may a value filtered in float leave that of its neighbours.
constexpr double filterRounding = 1e-5;

constexpr int rangeBins = 4096;

// The largest of any run of bins, in constant time: tables of runs of 1, 2, 4, …
class LargestOfRuns {
public:
  explicit LargestOfRuns(std::vector<double> values) {
    m_tables.push_back(std::move(values));
    for (std::size_t run = 1; 2 * run <= m_tables.front().size(); run *= 2) {
      const std::vector<double>& halves = m_tables.back();
      std::vector<double> table(halves.size() - run);
      for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = std::max(halves[i], halves[i + run]);
      m_tables.push_back(std::move(table));
    }
  }

  double within(int first, int last) const {
    const auto length = static_cast<unsigned>(last - first + 1);
    const int power = std::bit_width(length) - 1;
    const auto& table = m_tables[static_cast<std::size_t>(power)];
    return std::max(table[static_cast<std::size_t>(first)],
                    table[static_cast<std::size_t>(last + 1 - (1 << power))]);
  }

private:
  std::vector<std::vector<double>> m_tables;
};

// What a transfer function has over an interval of values, looked up in bins over the volume's range.
class FunctionOverRanges {
public:
  FunctionOverRanges(const TransferFunction& function, const ValueRange& range,
                     const std::vector<FunctionBand>& bands)
      : m_range(range),
        m_perValue(range.highest > range.lowest ? rangeBins / (range.highest - range.lowest) : 0.0),
        m_opacities(opacities(function, range)), m_bands(perWidth(bands)) {}

  double largestOpacity(const ValueRange& values) const {
    return m_opacities.within(binOf(values.lowest), binOf(values.highest));
  }

  // 1 / width of the narrowest band, 0 without any.
  double bandsPerValue(const ValueRange& values) const {
    return m_bands.within(binOf(values.lowest), binOf(values.highest));
  }

private:
  int binOf(double value) const {
    return static_cast<int>(std::clamp((value - m_range.lowest) * m_perValue, 0.0, rangeBins - 1.0));
  }

  static std::vector<double> opacities(const TransferFunction& function, const ValueRange& range) {
    const double width = (range.highest - range.lowest) / rangeBins;
    std::vector<double> values;
    values.reserve(rangeBins);
    for (int i = 0; i < rangeBins; ++i)
      values.push_back(
          largestOpacityWithin(function, range.lowest + i * width, range.lowest + (i + 1) * width));
    return values;
  }

  std::vector<double> perWidth(const std::vector<FunctionBand>& bands) const {
    std::vector<double> values(rangeBins, 0.0);
    for (const FunctionBand& band : bands) {
      if (band.at.highest < m_range.lowest || band.at.lowest > m_range.highest)
        continue;
      for (int i = binOf(band.at.lowest); i <= binOf(band.at.highest); ++i)
        values[static_cast<std::size_t>(i)] = std::max(values[static_cast<std::size_t>(i)], 1.0 / band.width);
    }
    return values;
  }

  ValueRange m_range;
  double m_perValue;
  LargestOfRuns m_opacities;
  LargestOfRuns m_bands;
};

// The first rung whose step is at most as long.
int rungFor(double step) {
  return static_cast<int>(std::ceil(2.0 * std::log2(2.0 / step) - 1e-9));
}

std::int8_t plainRung(double extinctionPerMm, double bendPerMm2, double commonPerMm, double spacing) {
  constexpr int coarsest = -64;
  if (!(extinctionPerMm > 0.0) || !(bendPerMm2 > 0.0) || !(commonPerMm > 0.0))
    return coarsest;
  const double d = extinctionPerMm * spacing * (bendPerMm2 * spacing / commonPerMm);
  return static_cast<std::int8_t>(std::clamp(rungFor(std::cbrt(1.0 / d)), coarsest, finestRung));
}

// What one function asks of the steps in blocks.
class FunctionRungs {
public:
  FunctionRungs(const BlockFacts& facts, const TransferFunction& function, double smallestSpacingMm)
      : m_facts(facts), m_unitDistanceMm(function.unitDistanceMm), m_smallestMm(smallestSpacingMm),
        m_over(function, facts.range, bandsToResolve(function, smallestSpacingMm)),
        m_margin(filterRounding * (facts.range.highest - facts.range.lowest)) {}

  // Makes the rungs of a block as fine as this function needs them; false where none is fine enough.
  bool addTo(StepRungs& rungs, const FieldFacts& block, bool isEdge) const {
    const ValueRange values{block.range.lowest - m_margin, block.range.highest + m_margin};
    const double opacity = m_over.largestOpacity(values);
    if (!(opacity > 0.0))
      return true;
    const double bend = std::max(block.bendPerMm2, isEdge ? m_facts.commonPerMm / m_smallestMm : 0.0);
    const std::int8_t plain =
        plainRung(extinctionPerMm(opacity, m_unitDistanceMm), bend, m_facts.commonPerMm, m_smallestMm);
    const double bandsPerStep = 2.0 * m_over.bandsPerValue(values) * block.steepestPerMm * m_smallestMm;
    int resolving = bandsPerStep > 0.0 ? std::max(rungFor(1.0 / bandsPerStep), 0) : 0;
    if (isEdge)
      resolving = std::max(resolving, rungFor(0.5));
    rungs.plain = rungs.isEmpty ? plain : std::max(rungs.plain, plain);
    rungs.isEmpty = false;
    rungs.resolving = std::max(rungs.resolving, static_cast<std::uint8_t>(std::min(resolving, finestRung)));
    return resolving <= finestRung;
  }

private:
  const BlockFacts& m_facts;
  double m_unitDistanceMm;
  double m_smallestMm;
  FunctionOverRanges m_over;
  double m_margin;
};

} // namespace

BlockFacts blockFacts(const Volume& volume, const Effort& effort) {
  BlockFacts result;
  result.range = volume.range();
  result.commonPerMm = steepness(volume);
  const glm::ivec3 cells = glm::max(volume.grid().dims - 1, glm::ivec3(1));
  const glm::ivec3 blocks = result.blocks = (cells + factCells - 1) / factCells;
  result.facts =
      RoomVector<FieldFacts>(static_cast<std::size_t>(blocks.x) * blocks.y * blocks.z, volume.room());
  const RowPieces rows(blocks, factCells * factCells * factCells);
  visitVoxels(volume, [&]<class T>(const StoredVoxels<T>& stored) {
    shareOut(rows.pieces(), effort, [&](Pieces& pieces) {
      RowGatherer<T> gatherer(volume, stored);
      for (int piece = pieces.next(); piece >= 0; piece = pieces.next())
        rows.forEachRow(piece, [&](int j, int k) {
          gatherer.gather(j, k, blocks.x, &result.facts[voxelOffset(blocks, 0, j, k)]);
        });
    });
  });
  return result;
}

std::vector<FunctionBand> bandsToResolve(const TransferFunction& function, double smallestSpacingMm) {
  return bandsOf(overDistance(function, smallestSpacingMm), leastBand);
}

BlockSteps blockSteps(const BlockFacts& facts, const TransferFunction& function, double smallestSpacingMm,
                      const BlockWeights& weights, const Effort& effort) {
  return blockSteps(facts, {function}, {}, smallestSpacingMm, weights, effort);
}

BlockSteps blockSteps(const BlockFacts& facts, const std::vector<TransferFunction>& functions,
                      const BlockLooks& looks, double smallestSpacingMm, const BlockWeights& weights,
                      const Effort& effort) {
  BlockSteps steps;
  steps.blocks = facts.blocks;
  steps.rungs = RoomVector<StepRungs>(facts.facts.size(), facts.facts.get_allocator().room());
  std::vector<FunctionRungs> ofFunctions;
  ofFunctions.reserve(functions.size());
  for (const TransferFunction& function : functions)
    ofFunctions.emplace_back(facts, function, smallestSpacingMm);
  std::atomic<bool> resolvesFunction = true;
  const auto rungsOf = [&](const FieldFacts& block, BlockWeight weight, LookBits ofBlock) {
    StepRungs rungs;
    if (weight == BlockWeight::none)
      return rungs;
    const bool isEdge = weight == BlockWeight::varying || std::popcount(ofBlock) > 1;
    for (; ofBlock != 0; ofBlock &= ofBlock - 1)
      if (!ofFunctions[static_cast<std::size_t>(std::countr_zero(ofBlock))].addTo(rungs, block, isEdge))
        resolvesFunction = false;
    return rungs;
  };
  const RowPieces rows(facts.blocks);
  forEachPiece(rows.pieces(), effort, [&](int piece) {
    rows.forEachRow(piece, [&](int j, int k) {
      const std::size_t first = voxelOffset(facts.blocks, 0, j, k);
      for (std::size_t i = first; i < first + static_cast<std::size_t>(facts.blocks.x); ++i)
        steps.rungs[i] = rungsOf(facts.facts[i], weights.empty() ? BlockWeight::all : weights[i],
                                 looks.empty() ? LookBits{1} : looks[i]);
    });
  });
  steps.resolvesFunction = resolvesFunction;
  return steps;
}

BlockWeights factWeights(const Region& region, const BlockFacts& facts, const Effort& effort) {
  if (!isRestricting(region))
    return {};
  return blockWeights(region, {facts.blocks, glm::ivec3(factCells)}, effort,
                      facts.facts.get_allocator().room());
}

int rungIn(const StepRungs& block, double fineness, double transmittance) {
  const int wanted = block.plain + wholeRungs(fineness) - coarserBehind(transmittance);
  return std::clamp(std::max(wanted, static_cast<int>(block.resolving)), 0, finestRung);
}

} // namespace limn
