// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/SavedState.h"

#include <epoxy/gl.h>

namespace limn {
namespace {

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
