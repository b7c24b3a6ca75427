// SPDX-License-Identifier: GPL-3.0-or-later
#include "regions/PiecePick.h"

#include "scene/LabelLooks.h"
#include "scene/volume/NearestVoxel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace limn {
namespace {

constexpr double leastShown = 0.02; // as for what is visible (DEFINITION section 8)
constexpr double leastOfSeed = 0.5; // of its opacity, which belongs to a piece
constexpr int reachVoxels = 2;
constexpr double notchShare = 0.02;      // of the range of values
constexpr double ownShare = 0.1;         // of a piece's range that has two ends of its own
constexpr double narrowestShare = 0.002; // of the range of values, from which a range of one value can widen
constexpr double upperShare = 0.2;       // of what lies above the seed's value
constexpr double aroundMm = 2.0;
constexpr double deviations = 2.5;
constexpr double leastAround = 0.005; // of the range of values

// Ranges in ascending order; those that touch become one.
class Ranges {
public:
  void add(double low, double high) {
    if (!m_all.empty() && low <= m_all.back().y)
      m_all.back().y = std::max(m_all.back().y, high);
    else
      m_all.emplace_back(low, high);
  }

  // Nothing where there are none.
  std::optional<glm::dvec2> nearestTo(double value) const {
    const auto away = [value](const glm::dvec2& range) {
      return std::max({range.x - value, value - range.y, 0.0});
    };
    const auto nearest = std::min_element(m_all.begin(), m_all.end(),
                                          [&](const auto& a, const auto& b) { return away(a) < away(b); });
    return nearest == m_all.end() ? std::nullopt : std::optional(*nearest);
  }

private:
  std::vector<glm::dvec2> m_all;
};

// The part of the line between two points that is opaque enough.
void addPart(const ControlPoint& from, const ControlPoint& to, double least, Ranges& ranges) {
  const bool begins = from.opacity >= least, ends = to.opacity >= least;
  if (!begins && !ends)
    return;
  const double crossing = begins && ends ? 0.0
                                         : from.value + (least - from.opacity) / (to.opacity - from.opacity) *
                                                            (to.value - from.value);
  ranges.add(begins ? from.value : crossing, ends ? to.value : crossing);
}

bool isKept(const Region& keep, const glm::ivec3& voxel) {
  return !keep.labels ||
         keep.weights[keep.labels->placeAt(voxelOffset(keep.labels->dims(), voxel.x, voxel.y, voxel.z))] >
             0.0;
}

double seedValueOf(const ConnectedPiece& piece, const Volume& volume) {
  return valueAt(volume, worldToIndex(volume.grid(), piece.seedMm));
}

struct Sums {
  std::size_t count = 0;
  double sum = 0.0;
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
};

} // namespace

std::optional<glm::dvec2> rangeAround(const TransferFunction& function, const ValueRange& values,
                                      double value, double least) {
  const std::vector<ControlPoint>& points = function.points;
  if (points.empty())
    return std::nullopt;
  Ranges ranges;
  if (points.front().opacity >= least)
    ranges.add(std::min(values.lowest, points.front().value), points.front().value);
  for (std::size_t n = 0; n + 1 < points.size(); ++n)
    addPart(points[n], points[n + 1], least, ranges);
  if (points.back().opacity >= least)
    ranges.add(points.back().value, std::max(values.highest, points.back().value));
  return ranges.nearestTo(value);
}

std::optional<ConnectedPiece> pieceAt(const Scene& scene, const glm::dvec3& worldMm) {
  const Volume& volume = *scene.volume;
  const Grid& grid = volume.grid();
  const glm::ivec3 middle(glm::floor(worldToIndex(grid, worldMm) + 0.5));
  glm::ivec3 seed(0);
  double most = 0.0, seedValue = 0.0;
  const LabelLooks looks = labelLooks(scene);
  const TransferFunction* ofSeed = &scene.transferFunction;
  for (int z = -reachVoxels; z <= reachVoxels; ++z)
    for (int y = -reachVoxels; y <= reachVoxels; ++y)
      for (int x = -reachVoxels; x <= reachVoxels; ++x) {
        const glm::ivec3 voxel = middle + glm::ivec3(x, y, z);
        if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) ||
            glm::any(glm::greaterThanEqual(voxel, grid.dims)) || !isKept(scene.keep, voxel))
          continue;
        const double value = valueAt(volume, glm::dvec3(voxel));
        const TransferFunction& function =
            functionAt(looks, scene.keep, voxelOffset(grid.dims, voxel.x, voxel.y, voxel.z));
        const double opacity = classify(function, value).opacity;
        if (opacity <= most)
          continue;
        most = opacity;
        seed = voxel;
        seedValue = value;
        ofSeed = &function;
      }
  if (most < leastShown)
    return std::nullopt;
  const auto range = rangeAround(*ofSeed, volume.range(), seedValue, leastOfSeed * most);
  return ConnectedPiece{indexToWorld(grid, glm::dvec3(seed)), *range, 1, ConnectedPiece::Fate::hidden};
}

ConnectedPiece narrowed(const ConnectedPiece& piece, const Volume& volume, double notches) {
  const ValueRange& values = volume.range();
  const double seed = seedValueOf(piece, volume);
  const double span = values.highest - values.lowest;
  const bool hasLow = piece.range.x > values.lowest, hasHigh = piece.range.y < values.highest;
  const double notch = hasLow && hasHigh ? std::clamp(ownShare * (piece.range.y - piece.range.x),
                                                      narrowestShare * span, notchShare * span)
                                         : notchShare * span;
  const double by = notches * notch;
  ConnectedPiece other = piece;
  // One that reaches from end to end is narrowed from below: what is bright is meant more often.
  if (hasLow || !hasHigh)
    other.range.x = std::clamp(piece.range.x + by, std::min(values.lowest, seed), seed);
  if (hasHigh)
    other.range.y = std::clamp(piece.range.y - by, seed, std::max(values.highest, seed));
  return other;
}

ConnectedPiece narrowedAbove(const ConnectedPiece& piece, const Volume& volume, double notches) {
  const ValueRange& values = volume.range();
  const double seed = seedValueOf(piece, volume);
  const double least = narrowestShare * (values.highest - values.lowest);
  const double above = std::min(piece.range.y, values.highest) - seed;
  const double from = notches < 0.0 ? std::max(above, least) : above;
  ConnectedPiece other = piece;
  other.range.y =
      std::clamp(seed + from * std::pow(1.0 - upperShare, notches), seed, std::max(values.highest, seed));
  if (notches > 0.0 && other.range.y - seed < least)
    other.range.y = seed;
  return other;
}

bool isNarrowest(const ConnectedPiece& piece, const Volume& volume) {
  return narrowed(piece, volume, 1.0).range == piece.range;
}

ConnectedPiece withValuesAround(const ConnectedPiece& piece, const Volume& volume, const Region& keep,
                                const glm::dvec3& worldMm) {
  const Grid& grid = volume.grid();
  const glm::dvec3 middle = worldToIndex(grid, worldMm);
  const glm::dvec3 reach = aroundMm / grid.spacingMm + 1.0;
  const glm::ivec3 first = glm::max(glm::ivec3(glm::ceil(middle - reach)), glm::ivec3(0));
  const glm::ivec3 last = glm::min(glm::ivec3(glm::floor(middle + reach)), grid.dims - 1);
  std::vector<std::pair<double, glm::ivec3>> found;
  double sum = 0.0, squares = 0.0;
  for (int z = first.z; z <= last.z; ++z)
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x) {
        const double value = valueAt(volume, glm::dvec3(x, y, z));
        if (value < piece.range.x || value > piece.range.y ||
            glm::length((glm::dvec3(x, y, z) - middle) / reach) > 1.0 || !isKept(keep, {x, y, z}))
          continue;
        found.emplace_back(value, glm::ivec3(x, y, z));
        sum += value;
        squares += value * value;
      }
  if (found.empty())
    return piece;
  const auto count = static_cast<double>(found.size());
  const double mean = sum / count;
  const double deviation = std::sqrt(std::max(0.0, squares / count - mean * mean));
  const double beside =
      std::max(deviations * deviation, leastAround * (volume.range().highest - volume.range().lowest));
  ConnectedPiece other = piece;
  other.range = {mean - beside, mean + beside};
  // How far a piece may reach is told from its seed, so that moves only where it must.
  const std::optional<glm::ivec3> seed = nearestVoxel(worldToIndex(grid, piece.seedMm), grid.dims);
  const double atSeed = seed ? valueAt(volume, glm::dvec3(*seed)) : 0.0;
  if (seed && isKept(keep, *seed) && atSeed >= other.range.x && atSeed <= other.range.y)
    return other;
  const auto nearest =
      std::ranges::min_element(found, {}, [mean](const auto& one) { return std::abs(one.first - mean); });
  other.seedMm = indexToWorld(grid, glm::dvec3(nearest->second));
  return other;
}

SetFigures figuresOf(const BitGrid& set, const Volume& volume, const glm::dvec2& range,
                     const Effort& effort) {
  const glm::ivec3& dims = set.dims();
  const VoxelMask& invalid = volume.invalidMask();
  const Rescale& rescale = volume.rescale();
  std::vector<Sums> slices(static_cast<std::size_t>(dims.z)); // summed in order: the same for any threads
  visitVoxels(volume, [&](const auto& stored) {
    forEachPiece(dims.z, effort, [&](int z) {
      Sums& sums = slices[static_cast<std::size_t>(z)];
      for (int y = 0; y < dims.y; ++y)
        for (int w = 0; w < set.rowWords(); ++w) {
          const std::size_t first = voxelOffset(dims, w * BitGrid::wordBits, y, z);
          BitGrid::Word word = set.row(y, z)[w];
          if (!invalid.empty())
            word &= ~invalid.from(first);
          for (; word != 0; word &= word - 1) {
            const std::size_t voxel = first + static_cast<std::size_t>(std::countr_zero(word));
            const double value = rescale.slope * static_cast<double>(stored[voxel]) + rescale.intercept;
            if (value < range.x || value > range.y)
              continue;
            ++sums.count;
            sums.sum += value;
            sums.lowest = std::min(sums.lowest, value);
            sums.highest = std::max(sums.highest, value);
          }
        }
    });
  });
  Sums all;
  for (const Sums& slice : slices) {
    all.count += slice.count;
    all.sum += slice.sum;
    all.lowest = std::min(all.lowest, slice.lowest);
    all.highest = std::max(all.highest, slice.highest);
  }
  if (all.count == 0)
    return {};
  const glm::dvec3& spacing = volume.grid().spacingMm;
  return {static_cast<double>(all.count) * spacing.x * spacing.y * spacing.z / 1000.0,
          all.sum / static_cast<double>(all.count),
          {all.lowest, all.highest}};
}

} // namespace limn
