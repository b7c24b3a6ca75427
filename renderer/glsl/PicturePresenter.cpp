// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl/PicturePresenter.h"

#include "glsl/programs/ShaderVariant.h"
#include "scene/view/CompareLayout.h"

#include <epoxy/gl.h>

namespace limn {
namespace {

ShaderSource sourceOf(const char* name) {
  ShaderSource source;
  source.append("prelude", "#version 130\n");
  source.append(name, embeddedShader(name));
  return source;
}

} // namespace

PicturePresenter::PicturePresenter()
    : m_program(sourceOf("present.vert.glsl"), sourceOf("present.frag.glsl")) {}

void PicturePresenter::show(unsigned texture, const Placement& placement,
                            const glm::dvec3& background) const {
  draw(texture, texture, placement, background, 0.0);
}

void PicturePresenter::showDifference(unsigned left, unsigned right, const Placement& placement,
                                      const glm::dvec3& background, double gain) const {
  draw(left, right, placement, background, gain);
}

void PicturePresenter::draw(unsigned left, unsigned right, const Placement& placement,
                            const glm::dvec3& background, double gain) const {
  const PixelRect& place = placement.place;
  const PixelRect& part = placement.part;
  const int height = placement.framebufferHeight;
  glViewport(place.topLeft.x, height - place.topLeft.y - place.size.y, place.size.x, place.size.y);
  glEnable(GL_SCISSOR_TEST);
  glScissor(part.topLeft.x, height - part.topLeft.y - part.size.y, part.size.x, part.size.y);
  m_program.use();
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, right);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, left);
  m_program.set("u_left", 0);
  m_program.set("u_right", 1);
  m_program.set("u_background", glm::vec3(background));
  m_program.set("u_gain", static_cast<float>(gain));
  m_program.set("u_leftBrighter", glm::vec3(leftBrighterColor));
  m_program.set("u_rightBrighter", glm::vec3(rightBrighterColor));
  glBindVertexArray(m_vertexArray.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glUseProgram(0);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glDisable(GL_SCISSOR_TEST);
}

} // namespace limn
