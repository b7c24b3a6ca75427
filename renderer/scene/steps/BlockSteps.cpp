// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/steps/BlockSteps.h"

#include "scene/steps/LocalSteps.h"
#include "scene/volume/RowPieces.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

namespace limn {
namespace {

// Less of a peak or valley changes no channel by much more than a level in the blocks that it concerns.
constexpr double leastBand = 0.02;

// By this much of the volume's range may a value filtered in float leave that of its neighbours.
constexpr double filterRounding = 1e-5;

constexpr int binCount = 4096;

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
        m_perValue(range.highest > range.lowest ? binCount / (range.highest - range.lowest) : 0.0),
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
    return static_cast<int>(std::clamp((value - m_range.lowest) * m_perValue, 0.0, binCount - 1.0));
  }

  static std::vector<double> opacities(const TransferFunction& function, const ValueRange& range) {
    const double width = (range.highest - range.lowest) / binCount;
    std::vector<double> values;
    values.reserve(binCount);
    for (int i = 0; i < binCount; ++i)
      values.push_back(
          largestOpacityWithin(function, range.lowest + i * width, range.lowest + (i + 1) * width));
    return values;
  }

  std::vector<double> perWidth(const std::vector<FunctionBand>& bands) const {
    std::vector<double> values(binCount, 0.0);
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

} // namespace

std::vector<FunctionBand> bandsToResolve(const TransferFunction& function, double smallestSpacingMm) {
  return bandsOf(overDistance(function, smallestSpacingMm), leastBand);
}

BlockSteps blockSteps(const BlockFacts& facts, const TransferFunction& function, double smallestSpacingMm,
                      const BlockWeights& weights, const Effort& effort) {
  BlockSteps steps;
  steps.blocks = facts.blocks;
  steps.rungs = RoomVector<StepRungs>(facts.facts.size(), facts.facts.get_allocator().room());
  const ValueRange& all = facts.range;
  const FunctionOverRanges over(function, all, bandsToResolve(function, smallestSpacingMm));
  const double margin = filterRounding * (all.highest - all.lowest);
  std::atomic<bool> resolvesFunction = true;
  const auto rungsOf = [&](const FieldFacts& block, BlockWeight weight) {
    const ValueRange values{block.range.lowest - margin, block.range.highest + margin};
    const double opacity = over.largestOpacity(values);
    StepRungs rungs;
    if (!(opacity > 0.0) || weight == BlockWeight::none)
      return rungs;
    rungs.isEmpty = false;
    const bool isEdge = weight == BlockWeight::varying;
    const double bend = std::max(block.bendPerMm2, isEdge ? facts.commonPerMm / smallestSpacingMm : 0.0);
    rungs.plain = plainRung(extinctionPerMm(opacity, function.unitDistanceMm), bend, facts.commonPerMm,
                            smallestSpacingMm);
    const double bandsPerStep = 2.0 * over.bandsPerValue(values) * block.steepestPerMm * smallestSpacingMm;
    int resolving = bandsPerStep > 0.0 ? std::max(rungFor(1.0 / bandsPerStep), 0) : 0;
    if (isEdge)
      resolving = std::max(resolving, rungFor(0.5));
    if (resolving > finestRung)
      resolvesFunction = false;
    rungs.resolving = static_cast<std::uint8_t>(std::min(resolving, finestRung));
    return rungs;
  };
  const RowPieces rows(facts.blocks);
  forEachPiece(rows.pieces(), effort, [&](int piece) {
    rows.forEachRow(piece, [&](int j, int k) {
      const std::size_t first = voxelOffset(facts.blocks, 0, j, k);
      for (std::size_t i = first; i < first + static_cast<std::size_t>(facts.blocks.x); ++i)
        steps.rungs[i] = rungsOf(facts.facts[i], weights.empty() ? BlockWeight::same : weights[i]);
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
