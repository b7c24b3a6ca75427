// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/framing/Outermost.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

namespace limn {

// How far along the direction things lie, but for a constant.
struct Outermost::Measure {
  Measure(const Grid& grid, int unitVoxels, const glm::dvec3& direction)
      : perVoxel((glm::transpose(grid.direction) * direction) * grid.spacingMm) {
    const glm::dvec3 perUnit = static_cast<double>(unitVoxels) * perVoxel;
    perBlock = static_cast<double>(blockUnits) * perUnit;
    for (int bit = 0; bit < 64; ++bit) {
      const int x = bit % 8, y = bit / 8;
      ofBit[static_cast<std::size_t>(bit)] = perUnit.x * x + perUnit.y * y;
    }
    perWord = perUnit.z;
    constexpr double steps = blockUnits - 1;
    lowest = steps * (std::min(perUnit.x, 0.0) + std::min(perUnit.y, 0.0) + std::min(perUnit.z, 0.0));
    highest = steps * (std::max(perUnit.x, 0.0) + std::max(perUnit.y, 0.0) + std::max(perUnit.z, 0.0));
  }

  // Of a block's first unit; all of its units lie between lowest and highest beyond.
  double of(const VisibleBlock& block) const { return glm::dot(perBlock, glm::dvec3(block.place)); }

  glm::dvec3 perVoxel;
  glm::dvec3 perBlock;
  std::array<double, 64> ofBit;
  double perWord;
  double lowest;
  double highest;
};

namespace {

// Values in bins, to find the one beyond which a given weight lies.
class Tally {
public:
  Tally(double from, double to) : m_from(from), m_perBin(to > from ? bins / (to - from) : 0.0) {}

  std::size_t binOf(double value) const {
    return static_cast<std::size_t>(std::clamp((value - m_from) * m_perBin, 0.0, bins - 1.0));
  }

  void add(double value, double weight) { m_weights[binOf(value)] += weight; }

  // The highest bin with which more than `left` lies, taking `left` down to what may lie beyond within it.
  std::size_t binBeyond(double& left) const {
    std::size_t bin = m_weights.size() - 1;
    while (bin > 0 && m_weights[bin] <= left)
      left -= m_weights[bin--];
    return bin;
  }

private:
  static constexpr double bins = 1024.0;
  double m_from;
  double m_perBin;
  std::array<double, 1024> m_weights{};
};

double notCounted(const VisibleVoxels& visible) {
  return std::floor(speckShare * static_cast<double>(visible.voxels));
}

// How many voxels lie before each place of a block, along all three axes.
class Sums {
public:
  explicit Sums(const VisibleVoxels& visible) : m_lower(visible.blocks.front().place) {
    glm::ivec3 upper = m_lower;
    for (const VisibleBlock& block : visible.blocks) {
      m_lower = glm::min(m_lower, block.place);
      upper = glm::max(upper, block.place);
    }
    m_size = upper - m_lower + 2;
    m_sums.resize(static_cast<std::size_t>(m_size.x) * m_size.y * m_size.z);
    for (const VisibleBlock& block : visible.blocks)
      m_sums[placeOf(block.place - m_lower + 1)] = block.voxels;
    for (int axis = 0; axis < 3; ++axis)
      addUp(axis);
  }

  // In the octant that begins beside the block, on the sides that `isAbove` says.
  std::uint64_t beside(const VisibleBlock& block, const glm::bvec3& isAbove) const {
    const glm::ivec3 at = block.place - m_lower;
    const glm::ivec3 from = glm::mix(glm::ivec3(0), at + 1, isAbove);
    const glm::ivec3 to = glm::mix(at, m_size - 1, isAbove);
    std::uint64_t voxels = 0; // of the corners of a box some count negatively; the sum never is
    for (int corner = 0; corner < 8; ++corner) {
      const glm::bvec3 isTo(corner & 1, corner & 2, corner & 4);
      const std::uint64_t sum = m_sums[placeOf(glm::mix(from, to, isTo))];
      voxels += (isTo.x + isTo.y + isTo.z) % 2 == 1 ? sum : -sum;
    }
    return voxels;
  }

private:
  std::size_t placeOf(const glm::ivec3& at) const {
    return (static_cast<std::size_t>(at.z) * m_size.y + at.y) * m_size.x + at.x;
  }

  void addUp(int axis) {
    glm::ivec3 step(0);
    step[axis] = 1;
    const std::size_t back = placeOf(step);
    for (int z = step.z; z < m_size.z; ++z)
      for (int y = step.y; y < m_size.y; ++y)
        for (int x = step.x; x < m_size.x; ++x)
          m_sums[placeOf({x, y, z})] += m_sums[placeOf({x, y, z}) - back];
  }

  glm::ivec3 m_lower;
  glm::ivec3 m_size; // one more than blocks
  std::vector<std::uint64_t> m_sums;
};

// One unit; the order of those that lie equally far is that of the blocks.
struct Met {
  double value;
  double weight;
  const VisibleBlock* block;
  int word;
  int bit;
};

} // namespace

VisibleVoxels withoutInner(VisibleVoxels visible) {
  const Sums sums(visible);
  const double left = notCounted(visible);
  std::erase_if(visible.blocks, [&](const VisibleBlock& block) {
    for (int octant = 0; octant < 8; ++octant)
      if (static_cast<double>(sums.beside(block, glm::bvec3(octant & 1, octant & 2, octant & 4))) <= left)
        return false;
    return true;
  });
  visible.blocks.shrink_to_fit();
  return visible;
}

Outermost::Outermost(const Grid& grid, const VisibleVoxels& visible)
    : m_grid(grid), m_visible(visible), m_left(notCounted(visible)) {}

// What the voxel that is looked for lies at or beyond: blocks that lie beyond as a whole hold enough.
double Outermost::boundOf(const Measure& measure) const {
  const auto [least, most] =
      std::ranges::minmax(m_visible.blocks, {}, [&](const VisibleBlock& block) { return measure.of(block); });
  Tally tally(measure.of(least), measure.of(most));
  for (const VisibleBlock& block : m_visible.blocks)
    tally.add(measure.of(block), block.voxels);
  double left = m_left;
  const std::size_t bin = tally.binBeyond(left);
  double bound = measure.of(most);
  for (const VisibleBlock& block : m_visible.blocks)
    if (const double value = measure.of(block); tally.binOf(value) >= bin)
      bound = std::min(bound, value);
  return bound + measure.lowest;
}

// Calls `visit` for each visible unit at `bound` or beyond.
template <class Visit>
void Outermost::visitBeyond(const Measure& measure, double bound, const Visit& visit) const {
  for (const VisibleBlock& block : m_visible.blocks) {
    const double first = measure.of(block);
    if (first + measure.highest < bound)
      continue;
    int units = 0;
    for (const std::uint64_t word : block.units)
      units += std::popcount(word);
    const double weight = static_cast<double>(block.voxels) / units;
    for (int word = 0; word < blockUnits; ++word)
      for (std::uint64_t bits = block.units[static_cast<std::size_t>(word)]; bits != 0; bits &= bits - 1) {
        const int bit = std::countr_zero(bits);
        const double value = first + word * measure.perWord + measure.ofBit[static_cast<std::size_t>(bit)];
        if (value >= bound)
          visit(Met{value, weight, &block, word, bit});
      }
  }
}

glm::dvec3 Outermost::along(const glm::dvec3& direction) const {
  const int unit = m_visible.unitVoxels;
  const Measure measure(m_grid, unit, direction);
  double bound = boundOf(measure);
  // Rounding must not leave out what decides.
  bound -= 1e-9 * (measure.highest - measure.lowest);
  double most = bound;
  visitBeyond(measure, bound, [&](const Met& met) { most = std::max(most, met.value); });
  Tally tally(bound, most);
  visitBeyond(measure, bound, [&](const Met& met) { tally.add(met.value, met.weight); });
  double left = m_left;
  const std::size_t bin = tally.binBeyond(left);
  std::vector<Met> within;
  visitBeyond(measure, bound, [&](const Met& met) {
    if (tally.binOf(met.value) == bin)
      within.push_back(met);
  });
  std::ranges::stable_sort(within, std::ranges::greater(), &Met::value);
  auto found = within.begin();
  while (found + 1 != within.end() && found->weight <= left)
    left -= (found++)->weight;
  const glm::ivec3 units =
      blockUnits * found->block->place + glm::ivec3(found->bit % 8, found->bit / 8, found->word);
  return indexToWorld(m_grid, static_cast<double>(unit) * glm::dvec3(units) + 0.5 * (unit - 1));
}

} // namespace limn
