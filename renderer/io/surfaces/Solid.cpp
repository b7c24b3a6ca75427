// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/surfaces/Solid.h"

namespace limn {
namespace {

// Stored values between voxel centres, whose type is known: millions of places are asked for.
template <class Stored>
double storedBetween(const VoxelArray& array, const glm::ivec3& dims, const glm::dvec3& index) {
  const auto& stored = *std::get_if<StoredVoxels<Stored>>(&array);
  const glm::dvec3 p = glm::clamp(index, glm::dvec3(0.0), glm::dvec3(dims - 1));
  const glm::ivec3 low(p);
  const glm::dvec3 share = p - glm::dvec3(low);
  const std::size_t right = low.x + 1 < dims.x ? 1 : 0;
  const std::size_t below = low.y + 1 < dims.y ? static_cast<std::size_t>(dims.x) : 0;
  const std::size_t behind = low.z + 1 < dims.z ? static_cast<std::size_t>(dims.x) * dims.y : 0;
  const Stored* at = stored.data() + voxelOffset(dims, low.x, low.y, low.z);
  const auto alongX = [&](std::size_t from) {
    return static_cast<double>(at[from]) * (1.0 - share.x) + static_cast<double>(at[from + right]) * share.x;
  };
  const double front = alongX(0) * (1.0 - share.y) + alongX(below) * share.y;
  const double back = alongX(behind) * (1.0 - share.y) + alongX(behind + below) * share.y;
  return front * (1.0 - share.z) + back * share.z;
}

} // namespace

Solid::Solid(const Scene& scene, double isovalue)
    : m_volume(scene.volume), m_keep(scene.keep), m_isRestricted(isRestricting(scene.keep)),
      m_isovalue(isovalue) {
  const Grid& grid = m_volume->grid();
  const glm::dvec3 size(grid.dims);
  m_lower = scene.crop.lower * size - 0.5;
  m_upper = scene.crop.upper * size - 0.5;
  m_originMm = grid.originMm;
  for (int column = 0; column < 3; ++column) {
    glm::dvec3 unit(0.0);
    unit[column] = 1.0;
    m_toIndex[column] = worldVectorToIndex(grid, unit);
  }
  for (const double weight : m_keep.weights)
    m_isKept.push_back(weight >= 0.5 ? 1 : 0);
  m_storedAt = visitVoxels(*m_volume,
                           []<class Stored>(const StoredVoxels<Stored>&) { return &storedBetween<Stored>; });
}

double Solid::excess(const glm::dvec3& index) const {
  const Rescale& rescale = m_volume->rescale();
  return rescale.slope * m_storedAt(m_volume->stored(), m_volume->grid().dims, index) + rescale.intercept -
         m_isovalue;
}

double Solid::keeping(const glm::dvec3& index) const {
  return weightAt(m_keep, index) - 0.5;
}

void Solid::markRow(int first, int count, int j, int k, std::uint8_t* out) const {
  const std::size_t row = voxelOffset(m_volume->grid().dims, first, j, k);
  const Rescale rescale = m_volume->rescale();
  visitVoxels(*m_volume, [&](const auto& stored) {
    for (int i = 0; i < count; ++i)
      out[i] = rescale.slope * static_cast<double>(stored[row + i]) + rescale.intercept - m_isovalue >= 0.0;
  });
  if (m_isRestricted)
    for (int i = 0; i < count; ++i)
      out[i] &= m_isKept[m_keep.labels->placeAt(row + i)];
}

} // namespace limn
