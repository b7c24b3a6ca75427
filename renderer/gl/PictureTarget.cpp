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

constexpr GLenum capabilityNames[SavedState::capabilities] = {
    GL_BLEND, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE, GL_DITHER, GL_SCISSOR_TEST, GL_FRAMEBUFFER_SRGB};

constexpr GLenum blendFactorNames[] = {GL_BLEND_SRC_RGB, GL_BLEND_DST_RGB, GL_BLEND_SRC_ALPHA,
                                       GL_BLEND_DST_ALPHA};

void enable(GLenum capability, bool on) {
  if (on)
    glEnable(capability);
  else
    glDisable(capability);
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

SavedState::SavedState() {
  for (int i = 0; i < capabilities; ++i) {
    m_enabled[i] = glIsEnabled(capabilityNames[i]);
    glDisable(capabilityNames[i]);
  }
  glGetBooleanv(GL_COLOR_WRITEMASK, m_colorMask.data());
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glGetIntegerv(GL_VIEWPORT, m_viewport.data());
  glGetIntegerv(GL_SCISSOR_BOX, m_scissorBox.data());
  glGetIntegerv(GL_CURRENT_PROGRAM, &m_program);
  glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &m_vertexArray);
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &m_arrayBuffer);
  glGetIntegerv(GL_UNPACK_ALIGNMENT, &m_unpackAlignment);
  glGetIntegerv(GL_PIXEL_UNPACK_BUFFER_BINDING, &m_unpackBuffer);
  for (std::size_t i = 0; i < m_blendFactors.size(); ++i)
    glGetIntegerv(blendFactorNames[i], &m_blendFactors[i]);
  glGetIntegerv(GL_BLEND_EQUATION_RGB, &m_blendEquations[0]);
  glGetIntegerv(GL_BLEND_EQUATION_ALPHA, &m_blendEquations[1]);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glGetIntegerv(GL_ACTIVE_TEXTURE, &m_activeTexture);
  for (int unit = 0; unit < textureUnits; ++unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glGetIntegerv(GL_TEXTURE_BINDING_2D, &m_textures2D[unit]);
    glGetIntegerv(GL_TEXTURE_BINDING_3D, &m_textures3D[unit]);
  }
}

SavedState::~SavedState() {
  const auto factor = [this](std::size_t i) { return static_cast<GLenum>(m_blendFactors[i]); };
  glBlendFuncSeparate(factor(0), factor(1), factor(2), factor(3));
  glBlendEquationSeparate(static_cast<GLenum>(m_blendEquations[0]), static_cast<GLenum>(m_blendEquations[1]));
  for (int unit = 0; unit < textureUnits; ++unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, static_cast<GLuint>(m_textures2D[unit]));
    glBindTexture(GL_TEXTURE_3D, static_cast<GLuint>(m_textures3D[unit]));
  }
  glActiveTexture(static_cast<GLenum>(m_activeTexture));
  glPixelStorei(GL_UNPACK_ALIGNMENT, m_unpackAlignment);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, static_cast<GLuint>(m_unpackBuffer));
  glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(m_arrayBuffer));
  glBindVertexArray(static_cast<GLuint>(m_vertexArray));
  // A program that its owner deleted while it was in use goes with the first other one.
  const auto program = static_cast<GLuint>(m_program);
  glUseProgram(glIsProgram(program) == GL_TRUE ? program : 0);
  glScissor(m_scissorBox[0], m_scissorBox[1], m_scissorBox[2], m_scissorBox[3]);
  glViewport(m_viewport[0], m_viewport[1], m_viewport[2], m_viewport[3]);
  glColorMask(m_colorMask[0], m_colorMask[1], m_colorMask[2], m_colorMask[3]);
  for (int i = 0; i < capabilities; ++i)
    enable(capabilityNames[i], m_enabled[i]);
}

} // namespace limn
