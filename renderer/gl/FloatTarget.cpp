// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/FloatTarget.h"

#include "scene/basics/Error.h"

#include <epoxy/gl.h>

namespace limn {

FloatTarget::FloatTarget(const glm::ivec2& size) {
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &m_drawBefore);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &m_readBefore);
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &m_textureBefore);
  glBindTexture(GL_TEXTURE_2D, m_color.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size.x, size.y, 0, GL_RGBA, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(m_textureBefore));
  glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_color.name(), 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    restore();
    throw Error(Error::Kind::openGl, Message::tr("The graphics driver cannot draw a picture of %1×%2 pixels "
                                                 "in floats; try a smaller one or --engine cpu.")
                                         .arg(size.x)
                                         .arg(size.y));
  }
}

FloatTarget::~FloatTarget() {
  restore();
}

void FloatTarget::restore() const {
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(m_drawBefore));
  glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(m_readBefore));
}

Image readBack(const glm::ivec2& size) {
  Image flipped(size);
  GLint alignment = 4;
  glGetIntegerv(GL_PACK_ALIGNMENT, &alignment);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, flipped.pixels.data());
  glPixelStorei(GL_PACK_ALIGNMENT, alignment);
  // OpenGL's rows go from the bottom up.
  Image image(size);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x)
      image.at(x, y) = flipped.at(x, size.y - 1 - y);
  return image;
}

} // namespace limn
