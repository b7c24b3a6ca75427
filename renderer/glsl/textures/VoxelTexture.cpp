// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/textures/VoxelTexture.h"

#include "gl/DriverHealth.h"

#include <epoxy/gl.h>

namespace limn {

VoxelTexture::VoxelTexture(const glm::ivec3& size, Format format, const Message& what,
                           const FillSlice& fill) {
  const std::size_t texels = static_cast<std::size_t>(size.x) * size.y * size.z;
  m_bytes = texels * (format == Format::halves ? 8 : 4);
  const GLint stored = format == Format::halves ? GL_RGBA16F : GL_RGBA8;
  glBindTexture(GL_TEXTURE_3D, m_texture.name());
  forgetDriverErrors();
  glTexImage3D(GL_TEXTURE_3D, 0, stored, size.x, size.y, size.z, 0, GL_RGBA, GL_FLOAT, nullptr);
  if (glGetError() != GL_NO_ERROR)
    throw Error(Error::Kind::openGl,
                Message::tr("The graphics driver has no room for %1, %2 MB; draw without them.")
                    .arg(what)
                    .arg(m_bytes / 1000000));
  std::vector<glm::vec4> slice(static_cast<std::size_t>(size.x) * size.y);
  for (int k = 0; k < size.z; ++k) {
    fill(k, slice);
    glTexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, k, size.x, size.y, 1, GL_RGBA, GL_FLOAT, slice.data());
  }
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_3D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
    glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
}

} // namespace limn
