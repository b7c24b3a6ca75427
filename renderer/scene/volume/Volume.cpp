// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Volume.h"

#include "scene/basics/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace limn {
namespace {

// Differences, sums and gradients of scalars must be numbers, too.
constexpr double largestScalar = 1e300;

struct Sanitised {
  ValueRange range;
  std::size_t invalidVoxels = 0;
  std::vector<bool> invalid;
};

template <class T>
bool isInvalid(T stored, const std::optional<PaddingRange>& padding) {
  if constexpr (std::is_floating_point_v<T>)
    if (!std::isfinite(stored))
      return true;
  return padding && stored >= padding->first && stored <= padding->last;
}

// Finds the valid voxels and replaces the others by the stored value of the smallest valid scalar.
template <class T>
Sanitised sanitise(std::vector<T>& stored, const Rescale& rescale,
                   const std::optional<PaddingRange>& padding) {
  Sanitised result;
  T smallest = std::numeric_limits<T>::max();
  T largest = std::numeric_limits<T>::lowest();
  for (std::size_t i = 0; i < stored.size(); ++i) {
    if (isInvalid(stored[i], padding)) {
      if (result.invalid.empty())
        result.invalid.resize(stored.size(), false);
      result.invalid[i] = true;
      ++result.invalidVoxels;
      continue;
    }
    smallest = std::min(smallest, stored[i]);
    largest = std::max(largest, stored[i]);
  }
  if (result.invalidVoxels == stored.size())
    throw Error(Error::Kind::input, "The volume holds no valid voxel: every value is NaN, infinite or "
                                    "declared padding; check that the right series was chosen.");
  const bool rising = rescale.slope >= 0.0;
  const T replacement = rising ? smallest : largest;
  if (result.invalidVoxels > 0)
    for (std::size_t i = 0; i < stored.size(); ++i)
      if (result.invalid[i])
        stored[i] = replacement;
  const double atSmallest = rescale.slope * static_cast<double>(smallest) + rescale.intercept;
  const double atLargest = rescale.slope * static_cast<double>(largest) + rescale.intercept;
  result.range = rising ? ValueRange{atSmallest, atLargest} : ValueRange{atLargest, atSmallest};
  if (!(result.range.lowest >= -largestScalar && result.range.highest <= largestScalar))
    throw Error(Error::Kind::input, "The volume's values are not finite or beyond 1e300 after rescaling; its "
                                    "slope, its intercept or its voxels are damaged.");
  return result;
}

void requireUsableGrid(const Grid& grid, std::size_t voxels) {
  for (int axis = 0; axis < 3; ++axis) {
    if (grid.dims[axis] < 1)
      throw Error(Error::Kind::input, "The volume has no voxels along one axis.");
    if (!(grid.spacingMm[axis] > 0.0) || !std::isfinite(grid.spacingMm[axis]))
      throw Error(Error::Kind::input,
                  "The volume's voxel spacing is not a positive number; give it with --spacing X,Y,Z.");
  }
  const auto expected = static_cast<std::size_t>(grid.dims.x) * grid.dims.y * grid.dims.z;
  if (expected != voxels)
    throw Error(Error::Kind::input, "The volume has " + std::to_string(voxels) +
                                        " voxels where its dimensions ask for " + std::to_string(expected) +
                                        "; the file is truncated or its header is wrong.");
}

} // namespace

Volume::Volume(Grid grid, VoxelArray stored, Rescale rescale, std::optional<PaddingRange> padding,
               VolumeInfo info)
    : m_grid(grid), m_stored(std::move(stored)), m_rescale(rescale), m_info(std::move(info)) {
  requireUsableGrid(m_grid, voxelCount());
  Sanitised sanitised =
      std::visit([&](auto& voxels) { return sanitise(voxels, m_rescale, padding); }, m_stored);
  m_range = sanitised.range;
  m_invalidVoxels = sanitised.invalidVoxels;
  m_invalid = std::move(sanitised.invalid);
}

std::size_t Volume::voxelCount() const {
  return std::visit([](const auto& voxels) { return voxels.size(); }, m_stored);
}

double Volume::value(const glm::ivec3& index) const {
  const std::size_t offset = voxelOffset(m_grid.dims, index.x, index.y, index.z);
  return std::visit(
      [&](const auto& voxels) {
        return m_rescale.slope * static_cast<double>(voxels[offset]) + m_rescale.intercept;
      },
      m_stored);
}

std::string voxelTypeName(const VoxelArray& stored) {
  static constexpr const char* names[] = {"uint8",  "int8",  "uint16",  "int16",
                                          "uint32", "int32", "float32", "float64"};
  return names[stored.index()];
}

double valueAt(const Volume& volume, const glm::dvec3& index) {
  const glm::dvec3 last = glm::dvec3(volume.grid().dims - 1);
  const glm::dvec3 p = glm::clamp(index, glm::dvec3(0.0), last);
  const glm::ivec3 low = glm::ivec3(glm::floor(p));
  const glm::ivec3 high = glm::min(low + 1, volume.grid().dims - 1);
  const glm::dvec3 w = p - glm::dvec3(low);
  const auto alongX = [&](int j, int k) {
    return glm::mix(volume.value({low.x, j, k}), volume.value({high.x, j, k}), w.x);
  };
  const auto alongY = [&](int k) { return glm::mix(alongX(low.y, k), alongX(high.y, k), w.y); };
  return glm::mix(alongY(low.z), alongY(high.z), w.z);
}

} // namespace limn
