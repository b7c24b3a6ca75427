// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/light/Gradient.h"

#include "scene/light/GradientHistogram.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <thread>

namespace limn {
namespace {

// The power of two, value/mm, in which moduli are computed: about the steepest that the volume can hold, so
// that neither squares nor floats overflow or vanish, however large or small its values. Multiplying by it is
// exact.
double modulusUnit(const Volume& volume) {
  const double steepest = (volume.range().highest - volume.range().lowest) / smallestSpacingMm(volume.grid());
  return std::ldexp(1.0, std::clamp(std::ilogb(steepest), -1000, 1000));
}

// Voxels of one volume in their stored type, with differences in scalar units.
template <class T>
struct Stencil {
  const Volume& volume;
  const std::vector<T>& stored;
  double perUnit = 1.0 / modulusUnit(volume);
  glm::ivec3 dims = volume.grid().dims;
  std::size_t stride[3] = {1, static_cast<std::size_t>(dims.x), static_cast<std::size_t>(dims.x) * dims.y};

  // Derivative along one grid axis at a voxel, value/mm.
  double derivative(std::size_t offset, int index, int axis) const {
    const bool hasLower = index > 0;
    const bool hasUpper = index + 1 < dims[axis];
    const int distance = int(hasLower) + int(hasUpper);
    if (distance == 0)
      return 0.0;
    const double upper = static_cast<double>(stored[offset + (hasUpper ? stride[axis] : 0)]);
    const double lower = static_cast<double>(stored[offset - (hasLower ? stride[axis] : 0)]);
    return volume.rescale().slope * (upper - lower) / (distance * volume.grid().spacingMm[axis]);
  }

  glm::dvec3 alongAxes(int i, int j, int k) const {
    const std::size_t offset = voxelOffset(dims, i, j, k);
    return {derivative(offset, i, 0), derivative(offset, j, 1), derivative(offset, k, 2)};
  }

  // In units of `modulusUnit`.
  double modulus(int i, int j, int k) const { return glm::length(alongAxes(i, j, k) * perUnit); }

  bool isEligible(int i, int j, int k) const {
    const std::vector<bool>& invalid = volume.invalidMask();
    if (invalid.empty())
      return true;
    const std::size_t offset = voxelOffset(dims, i, j, k);
    const int index[3] = {i, j, k};
    if (invalid[offset])
      return false;
    for (int axis = 0; axis < 3; ++axis)
      if ((index[axis] > 0 && invalid[offset - stride[axis]]) ||
          (index[axis] + 1 < dims[axis] && invalid[offset + stride[axis]]))
        return false;
    return true;
  }
};

template <class T, class Function>
void forEachModulusOfSlice(const Stencil<T>& stencil, int k, Function&& function) {
  for (int j = 0; j < stencil.dims.y; ++j)
    for (int i = 0; i < stencil.dims.x; ++i)
      if (stencil.isEligible(i, j, k))
        function(stencil.modulus(i, j, k));
}

// Feeds the moduli, in units of `modulusUnit`, of all eligible voxels to one collector per core, each a copy
// of `empty`, and returns the collectors. Which voxel goes to which is left open: collect only what does not
// depend on it.
template <class Collector>
std::vector<Collector> collected(const Volume& volume, const Collector& empty) {
  const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
  std::vector<Collector> collectors(
      std::min<std::size_t>(cores, static_cast<std::size_t>(volume.grid().dims.z)), empty);
  visitVoxels(volume, [&]<class T>(const std::vector<T>& stored) {
    const Stencil<T> stencil{volume, stored};
    std::atomic<int> nextSlice{0};
    std::vector<std::jthread> threads;
    threads.reserve(collectors.size());
    for (Collector& collector : collectors)
      threads.emplace_back([&stencil, &nextSlice, &collector] {
        // Work on a copy: neighbouring collectors would share cache lines.
        Collector own = std::move(collector);
        for (int k = nextSlice++; k < stencil.dims.z; k = nextSlice++)
          forEachModulusOfSlice(stencil, k, [&own](double modulus) { own.add(modulus); });
        collector = std::move(own);
      });
  });
  return collectors;
}

struct LargestCollector {
  double largest = 0.0;
  void add(double modulus) { largest = std::max(largest, modulus); }
};

// Floats that are not negative order as their bits do.
constexpr int lowBits = 16;

struct HighBitsCollector {
  std::vector<std::uint64_t> counts = std::vector<std::uint64_t>(1u << (32 - lowBits), 0);
  void add(double modulus) { ++counts[std::bit_cast<std::uint32_t>(static_cast<float>(modulus)) >> lowBits]; }
};

struct LowBitsCollector {
  std::uint32_t high = 0;
  std::vector<std::uint64_t> counts = std::vector<std::uint64_t>(1u << lowBits, 0);
  void add(double modulus) {
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(modulus));
    if (bits >> lowBits == high)
      ++counts[bits & ((1u << lowBits) - 1)];
  }
};

struct BinCollector {
  double binsPerModulus = 0.0;
  std::vector<std::uint64_t> counts;
  void add(double modulus) {
    ++counts[std::min(static_cast<std::size_t>(modulus * binsPerModulus), counts.size() - 1)];
  }
};

template <class Collector>
std::vector<std::uint64_t> countsOf(const std::vector<Collector>& collectors) {
  std::vector<std::uint64_t> sum(collectors.front().counts.size(), 0);
  for (const Collector& collector : collectors)
    for (std::size_t i = 0; i < sum.size(); ++i)
      sum[i] += collector.counts[i];
  return sum;
}

// The bin that holds the element of a rank (from 1), which becomes its rank within the bin.
std::uint32_t binOfRank(const std::vector<std::uint64_t>& counts, std::uint64_t& rank) {
  std::uint32_t bin = 0;
  while (rank > counts[bin])
    rank -= counts[bin++];
  return bin;
}

} // namespace

glm::dvec3 gradientAtVoxel(const Volume& volume, const glm::ivec3& index) {
  const glm::dvec3 alongAxes = visitVoxels(volume, [&]<class T>(const std::vector<T>& stored) {
    return Stencil<T>{volume, stored}.alongAxes(index.x, index.y, index.z);
  });
  return volume.grid().direction * alongAxes;
}

glm::dvec3 gradientAt(const Volume& volume, const glm::dvec3& index) {
  const glm::ivec3 dims = volume.grid().dims;
  const glm::dvec3 p = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(dims - 1));
  const glm::ivec3 low = glm::ivec3(glm::floor(p));
  const glm::dvec3 w = p - glm::dvec3(low);
  glm::dvec3 sum(0.0);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 step(corner & 1, (corner >> 1) & 1, corner >> 2);
    const glm::dvec3 weights = glm::mix(1.0 - w, w, glm::dvec3(step));
    const double weight = weights.x * weights.y * weights.z;
    if (weight > 0.0)
      sum += weight * gradientAtVoxel(volume, glm::min(low + step, dims - 1));
  }
  return sum;
}

double largestGradient(const Volume& volume) {
  double largest = 0.0;
  for (const LargestCollector& collector : collected(volume, LargestCollector{}))
    largest = std::max(largest, collector.largest);
  return largest * modulusUnit(volume);
}

double gradientPercentile(const Volume& volume, double percent) {
  if (percent >= 100.0)
    return largestGradient(volume);
  // Count by the upper half of the float's bits, then within the bin of the rank by the lower half: exact
  // selection in two passes over the volume and without a copy of its gradients.
  const std::vector<std::uint64_t> highCounts = countsOf(collected(volume, HighBitsCollector{}));
  const std::uint64_t total = std::accumulate(highCounts.begin(), highCounts.end(), std::uint64_t{0});
  if (total == 0)
    return 0.0;
  const double wanted = std::ceil(percent / 100.0 * static_cast<double>(total));
  auto rank = static_cast<std::uint64_t>(std::clamp(wanted, 1.0, static_cast<double>(total)));
  LowBitsCollector empty;
  empty.high = binOfRank(highCounts, rank);
  const std::uint32_t low = binOfRank(countsOf(collected(volume, empty)), rank);
  return std::bit_cast<float>(empty.high << lowBits | low) * modulusUnit(volume);
}

Histogram gradientHistogram(const Volume& volume, int bins) {
  assert(bins > 0);
  const double largest = largestGradient(volume);
  BinCollector empty;
  const double binsPerModulus = bins / (largest / modulusUnit(volume));
  const bool isFlat = !std::isfinite(binsPerModulus);
  empty.binsPerModulus = isFlat ? 0.0 : binsPerModulus;
  empty.counts.assign(isFlat ? 1 : static_cast<std::size_t>(bins), 0);
  return {{0.0, largest}, countsOf(collected(volume, empty))};
}

double steepness(const Volume& volume) {
  constexpr int mostPerAxis = 32;
  const glm::ivec3 dims = volume.grid().dims;
  const glm::ivec3 stride = (dims + mostPerAxis - 1) / mostPerAxis;
  std::vector<double> moduli;
  visitVoxels(volume, [&]<class T>(const std::vector<T>& stored) {
    const Stencil<T> stencil{volume, stored};
    for (int k = stride.z / 2; k < dims.z; k += stride.z)
      for (int j = stride.y / 2; j < dims.y; j += stride.y)
        for (int i = stride.x / 2; i < dims.x; i += stride.x)
          if (stencil.isEligible(i, j, k))
            moduli.push_back(stencil.modulus(i, j, k));
  });
  if (moduli.empty())
    return 0.0;
  const auto rank =
      moduli.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(moduli.size() - 1));
  std::nth_element(moduli.begin(), rank, moduli.end());
  return *rank * modulusUnit(volume);
}

GradientReference resolvedReference(const Shading& shading) {
  if (!std::holds_alternative<AutomaticReference>(shading.gradientReference))
    return shading.gradientReference;
  if (shading.model == ShadingModel::robust)
    return PercentileReference{99.5};
  return LargestReference{};
}

GradientScale gradientScale(const Volume& volume, const Shading& shading) {
  const GradientReference reference = resolvedReference(shading);
  GradientScale scale;
  scale.largest = largestGradient(volume);
  if (const auto* percentile = std::get_if<PercentileReference>(&reference))
    scale.reference = gradientPercentile(volume, percentile->percent);
  else if (const auto* fixed = std::get_if<FixedReference>(&reference))
    scale.reference = fixed->valuePerMm;
  else
    scale.reference = scale.largest;
  return scale;
}

} // namespace limn
