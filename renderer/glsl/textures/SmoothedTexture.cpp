// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/textures/SmoothedTexture.h"

#include "engine/VolumeTooLarge.h"
#include "gl/DriverHealth.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <vector>

namespace limn {
namespace {

// Texels that are made and uploaded at a time: some ten ms on two cores.
constexpr std::size_t smoothedAtATime = std::size_t{1} << 22;

void requireRoom(bool isThere) {
  if (!isThere)
    throw VolumeTooLarge(Message::tr("The graphics card has no room for a smoothed copy of the volume beside "
                                     "it; set the smoothing of normals to 0, or draw with --engine cpu."));
}

} // namespace

double SmoothedTexture::uploadMore(const std::shared_ptr<const Volume>& smoothed, const VolumeTexture& volume,
                                   const VolumeRoom& room) {
  if (m_smoothed != smoothed) {
    m_texture.reset();
    m_smoothed.reset();
    m_size = volume.size();
    m_planesDone = 0;
    requireRoom(static_cast<double>(bytesOfFloats(m_size) + volume.bytes()) <= 1e6 * room.mostMb);
    m_texture.emplace();
    glBindTexture(GL_TEXTURE_3D, m_texture->name());
    forgetDriverErrors();
    glTexImage3D(GL_TEXTURE_3D, 0, GL_R32F, m_size.x, m_size.y, m_size.z, 0, GL_RED, GL_FLOAT, nullptr);
    const bool isAllocated = glGetError() == GL_NO_ERROR;
    if (!isAllocated)
      m_texture.reset();
    requireRoom(isAllocated);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
      glTexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
      glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
    m_smoothed = smoothed;
  }
  if (m_planesDone == m_size.z)
    return 1.0;
  const std::size_t plane = static_cast<std::size_t>(m_size.x) * m_size.y;
  const int end = std::min(m_planesDone + std::max(1, static_cast<int>(smoothedAtATime / plane)), m_size.z);
  std::vector<float> texels(plane * static_cast<std::size_t>(end - m_planesDone));
  fillPlanes(*smoothed, volume.reduction(), m_planesDone, end, texels.data());
  glBindTexture(GL_TEXTURE_3D, m_texture->name());
  glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, m_planesDone, m_size.x, m_size.y, end - m_planesDone, GL_RED,
                  GL_FLOAT, texels.data());
  m_planesDone = end;
  return static_cast<double>(m_planesDone) / m_size.z;
}

} // namespace limn
