// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/textures/LookTextures.h"

#include "gl/DriverHealth.h"
#include "scene/basics/Error.h"
#include "scene/regions/Reduction.h"
#include "scene/steps/BlockRanges.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace limn {
namespace {

void setNearest(GLenum target) {
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(target, filter, GL_NEAREST);
}

} // namespace

bool LookTextures::update(const Scene& scene, const VolumeTexture& volume) {
  const LabelLooks looks = labelLooks(scene);
  const Region& keep = scene.keep;
  const bool wasAny = m_looks.areAny();
  if (!looks.areAny()) {
    *this = {};
    return wasAny;
  }
  const bool hasFunctions = wasAny && m_looks.functions == looks.functions && m_own == scene.transferFunction;
  const bool hasLabels = wasAny && m_looks.ofLabel == looks.ofLabel && m_labels == keep.labels;
  if (hasFunctions && hasLabels)
    return false;
  m_looks = {}; // should the driver have no room
  if (!hasFunctions)
    tabulate(looks.functions, scene.transferFunction, scene.volume->range());
  if (!hasLabels)
    uploadLabels(keep, looks.ofLabel, volume);
  m_own = scene.transferFunction;
  m_labels = keep.labels;
  m_looks = looks;
  return !hasFunctions;
}

// The scene's own function has its row even where no label shows it: programs that leave looks out draw with
// it.
void LookTextures::tabulate(std::vector<TransferFunction> functions, const TransferFunction& own,
                            const ValueRange& range) {
  const bool isOwnShown = !functions.front().points.empty();
  functions.front() = own;
  std::vector<TransferFunction> common = withCommonPoints(functions);
  m_tables.clear();
  m_unitDistances.clear();
  for (const TransferFunction& function : common) {
    m_tables.push_back(tableOf(function, range));
    m_unitDistances.push_back(function.unitDistanceMm);
  }
  if (!isOwnShown)
    for (ControlPoint& point : common.front().points)
      point.opacity = 0.0;
  m_together = tableOf(unionOf(common), range);
  m_segmentsPerLook = static_cast<int>(m_tables.front().segments.size()) / 4;
  m_together.segments.clear();
  m_together.segmentsSize.y = 0;
  for (const PiecewiseTable& table : m_tables) {
    m_together.segments.insert(m_together.segments.end(), table.segments.begin(), table.segments.end());
    m_together.segmentsSize.y += table.segmentsSize.y;
    m_together.occupancy.insert(m_together.occupancy.end(), table.occupancy.begin(), table.occupancy.end());
  }
}

void LookTextures::uploadLabels(const Region& region, const std::vector<std::uint8_t>& lookOf,
                                const VolumeTexture& volume) {
  const Region texels = reduced(region, volume.reduction());
  const LabelMap& map = *texels.labels;
  const glm::ivec3& dims = map.dims();
  m_ofBlocks = blockLooks(map, lookOf, {volume.ranges().blocks(), glm::ivec3(blockSize)});
  const RoomVector<std::uint8_t> looks = looksOfVoxels(map, lookOf);
  RoomVector<std::uint8_t> cells = cellLooks(dims, looks);
  for (std::uint8_t& look : cells)
    look = look == severalLooks ? std::uint8_t{0} : static_cast<std::uint8_t>(look + 1);
  m_cellTexture.reset(); // two need not fit together
  m_labelTexture.reset();
  forgetDriverErrors();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  m_cellTexture.emplace();
  glBindTexture(GL_TEXTURE_3D, m_cellTexture->name());
  glTexImage3D(GL_TEXTURE_3D, 0, GL_R8, dims.x, dims.y, dims.z, 0, GL_RED, GL_UNSIGNED_BYTE, cells.data());
  setNearest(GL_TEXTURE_3D);
  m_labelTexture.emplace();
  glBindTexture(GL_TEXTURE_3D, m_labelTexture->name());
  glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, dims.x, dims.y, dims.z, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  setNearest(GL_TEXTURE_3D);
  if (glGetError() != GL_NO_ERROR)
    throw Error(Error::Kind::openGl,
                Message::tr("The graphics driver has no room for the looks of labels; draw "
                            "without them, or with --engine cpu."));
  std::vector<glm::u8vec4> plane(static_cast<std::size_t>(dims.x) * dims.y);
  for (int z = 0; z < dims.z; ++z) {
    for (int y = 0; y < dims.y; ++y) {
      const std::uint8_t* here = &looks[voxelOffset(dims, 0, y, z)];
      const std::uint8_t* above = &looks[voxelOffset(dims, 0, std::min(y + 1, dims.y - 1), z)];
      for (int x = 0; x < dims.x; ++x) {
        const int next = std::min(x + 1, dims.x - 1);
        plane[voxelOffset(dims, x, y, 0)] = {here[x], here[next], above[x], above[next]};
      }
    }
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, z, dims.x, dims.y, 1, GL_RGBA, GL_UNSIGNED_BYTE, plane.data());
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

} // namespace limn
