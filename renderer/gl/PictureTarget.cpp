// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/PictureTarget.h"

#include "scene/basics/Error.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace limn {
namespace {

void setSampling(unsigned texture, GLint filter) {
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

} // namespace

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
                                         .arg(size.x, size.y));
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

PictureTarget::PictureTarget() {
  setSampling(texture(), GL_LINEAR);
}

void PictureTarget::resize(const glm::ivec2& size) {
  if (size == m_size)
    return;
  glBindTexture(GL_TEXTURE_2D, texture());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size.x, size.y, 0, GL_RGBA, GL_FLOAT, nullptr);
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture(), 0);
  m_size = {0, 0};
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw Error(Error::Kind::openGl,
                Message::tr("The graphics driver cannot draw a picture of %1 × %2 pixels in 32-bit floats; "
                            "make the window smaller or install a driver with OpenGL 3.0 or newer.")
                    .arg(size.x, size.y));
  m_size = size;
}

void PictureTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.name());
}

Image PictureTarget::read() const {
  bind();
  return readBack(m_size);
}

void PictureTarget::write(const glm::ivec2& topLeft, const Image& pixels) {
  Image upwards(pixels.size);
  for (int y = 0; y < pixels.size.y; ++y)
    std::copy_n(&pixels.at(0, y), pixels.size.x, &upwards.at(0, pixels.size.y - 1 - y));
  glBindTexture(GL_TEXTURE_2D, texture());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexSubImage2D(GL_TEXTURE_2D, 0, topLeft.x, m_size.y - topLeft.y - pixels.size.y, pixels.size.x,
                  pixels.size.y, GL_RGBA, GL_FLOAT, upwards.pixels.data());
  glBindTexture(GL_TEXTURE_2D, 0);
}

ByteTexture::ByteTexture() {
  setSampling(texture(), GL_NEAREST);
}

void ByteTexture::upload(const glm::ivec2& size, const unsigned char* bytes) {
  glBindTexture(GL_TEXTURE_2D, texture());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size.x, size.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
  glBindTexture(GL_TEXTURE_2D, 0);
}

} // namespace limn
