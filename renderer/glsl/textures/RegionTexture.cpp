// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/textures/RegionTexture.h"

#include "gl/DriverHealth.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>

namespace limn {
namespace {

// The mean share of a box of voxels: what a texel of a reduced volume stands for.
std::uint16_t meanShare(const Region& region, const glm::ivec3& from, const glm::ivec3& to) {
  const glm::ivec3& dims = region.labels->dims();
  double sum = 0.0;
  for (int z = from.z; z < to.z; ++z)
    for (int y = from.y; y < to.y; ++y)
      for (int x = from.x; x < to.x; ++x)
        sum +=
            region.weights[region.labels->placeAt((static_cast<std::size_t>(z) * dims.y + y) * dims.x + x)];
  const glm::ivec3 box = to - from;
  return static_cast<std::uint16_t>(
      std::lround(65535.0 * sum / (static_cast<double>(box.x) * box.y * box.z)));
}

// A plane of texels with its apron, a copy of the outermost: weights are clamped there as the field is.
void fillPlane(const Region& region, const VolumeTexture& volume, int plane, std::vector<std::uint16_t>& to) {
  const glm::ivec3& dims = region.labels->dims();
  const glm::ivec3& size = volume.size();
  const glm::ivec3& reduction = volume.reduction();
  const int k = std::clamp(plane - 1, 0, size.z - 3);
  for (int y = 0; y < size.y; ++y) {
    const int j = std::clamp(y - 1, 0, size.y - 3);
    std::uint16_t* row = &to[static_cast<std::size_t>(y) * size.x];
    if (reduction == glm::ivec3(1))
      sharesOf(region, (static_cast<std::size_t>(k) * dims.y + j) * dims.x, static_cast<std::size_t>(dims.x),
               row + 1);
    else
      for (int i = 0; i < size.x - 2; ++i) {
        const glm::ivec3 from = glm::ivec3(i, j, k) * reduction;
        row[i + 1] = meanShare(region, from, glm::min(from + reduction, dims));
      }
    row[0] = row[1];
    row[size.x - 1] = row[size.x - 2];
  }
}

} // namespace

void RegionTexture::update(const Region& region, const VolumeTexture& volume) {
  if (m_region == region)
    return;
  m_texture.reset();
  m_blocks.clear();
  m_region = region;
  if (!isRestricting(region))
    return;
  m_blocks = blockWeights(region, {volume.ranges().blocks(), blockSize * volume.reduction()});
  m_texture.emplace();
  const glm::ivec3& size = volume.size();
  glBindTexture(GL_TEXTURE_3D, m_texture->name());
  forgetDriverErrors();
  glTexImage3D(GL_TEXTURE_3D, 0, GL_R16, size.x, size.y, size.z, 0, GL_RED, GL_UNSIGNED_SHORT, nullptr);
  if (glGetError() != GL_NO_ERROR)
    throw Error(Error::Kind::openGl, Message::tr("The graphics driver has no room for the kept region; draw "
                                                 "all of the volume, or with --engine cpu."));
  std::vector<std::uint16_t> plane(static_cast<std::size_t>(size.x) * size.y);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
  for (int z = 0; z < size.z; ++z) {
    fillPlane(region, volume, z, plane);
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, z, size.x, size.y, 1, GL_RED, GL_UNSIGNED_SHORT, plane.data());
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
}

} // namespace limn
