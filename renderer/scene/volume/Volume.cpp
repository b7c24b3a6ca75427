// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/volume/Volume.h"

#include "scene/basics/Error.h"
#include "scene/volume/ValidVoxels.h"

#include <cassert>
#include <cmath>

namespace limn {
namespace {

// Differences, sums and gradients of scalars must be numbers, too.
constexpr double largestScalar = 1e300;

// Of scalars, from those of stored values.
ValueRange rangeOf(const ValidVoxels& voxels, const Rescale& rescale) {
  const double a = rescale.slope * voxels.smallest + rescale.intercept;
  const double b = rescale.slope * voxels.largest + rescale.intercept;
  const ValueRange range = rescale.slope >= 0.0 ? ValueRange{a, b} : ValueRange{b, a};
  if (!(range.lowest >= -largestScalar && range.highest <= largestScalar))
    throw Error(Error::Kind::input,
                Message::tr("The volume's values are not finite or beyond 1e300 after rescaling; its slope, "
                            "its intercept or its voxels are damaged."));
  return range;
}

void requireUsableGrid(const Grid& grid, std::size_t voxels) {
  for (int axis = 0; axis < 3; ++axis) {
    if (grid.dims[axis] < 1)
      throw Error(Error::Kind::input, Message::tr("The volume has no voxels along one axis."));
    if (!(grid.spacingMm[axis] > 0.0) || !std::isfinite(grid.spacingMm[axis]))
      throw Error(
          Error::Kind::input,
          Message::tr("The volume's voxel spacing is not a positive number; give it with --spacing X,Y,Z."));
  }
  const auto expected = static_cast<std::size_t>(grid.dims.x) * grid.dims.y * grid.dims.z;
  if (expected != voxels)
    throw Error(Error::Kind::input, Message::tr("The volume has %1 voxels where its dimensions ask for %2; "
                                                "the file is truncated or its header is wrong.")
                                        .arg(voxels)
                                        .arg(expected));
}

} // namespace

Volume::Volume(Grid grid, VoxelArray stored, Rescale rescale, std::optional<PaddingRange> padding,
               VolumeInfo info, const Effort& effort, std::shared_ptr<Room> room)
    : m_grid(grid), m_rescale(rescale), m_info(std::move(info)), m_room(std::move(room)) {
  requireUsableGrid(m_grid, std::visit([](const auto& voxels) { return voxels.size(); }, stored));
  ValidVoxels valid = sanitise(stored, m_rescale, padding, effort, m_room);
  m_stored = std::make_shared<const VoxelArray>(std::move(stored));
  m_range = rangeOf(valid, m_rescale);
  m_invalidVoxels = valid.invalidVoxels;
  m_invalid = std::move(valid.invalid);
  m_counts = std::move(valid.counts);
}

Volume Volume::placed(const Grid& grid, VolumeInfo info) const {
  assert(grid.dims == m_grid.dims);
  Volume other = *this;
  other.m_grid = grid;
  other.m_info = std::move(info);
  return other;
}

std::size_t Volume::voxelCount() const {
  return std::visit([](const auto& voxels) { return voxels.size(); }, *m_stored);
}

double Volume::value(const glm::ivec3& index) const {
  const std::size_t offset = voxelOffset(m_grid.dims, index.x, index.y, index.z);
  return std::visit(
      [&](const auto& voxels) {
        return m_rescale.slope * static_cast<double>(voxels[offset]) + m_rescale.intercept;
      },
      *m_stored);
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
