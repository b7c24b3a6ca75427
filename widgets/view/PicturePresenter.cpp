// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/PicturePresenter.h"

#include <epoxy/gl.h>

namespace limn {
namespace {

// One triangle covers the viewport; its corners follow from the vertex number.
constexpr const char* vertexText = R"(#version 130
out vec2 v_place;
void main() {
  v_place = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
  gl_Position = vec4(2.0 * v_place - 1.0, 0.0, 1.0);
}
)";

// Puts a premultiplied picture over the background; with a gain, the difference of two.
constexpr const char* fragmentText = R"(#version 130
in vec2 v_place;
out vec4 fragColor;
uniform sampler2D u_left;
uniform sampler2D u_right;
uniform vec3 u_background;
uniform float u_gain;
vec3 over(vec4 picture) {
  return picture.rgb + (1.0 - picture.a) * u_background;
}
void main() {
  vec3 color = over(texture(u_left, v_place));
  if (u_gain > 0.0)
    color = u_gain * abs(color - over(texture(u_right, v_place)));
  fragColor = vec4(color, 1.0);
}
)";

ShaderSource sourceOf(const char* name, const char* text) {
  ShaderSource source;
  source.append(name, text);
  return source;
}

} // namespace

PicturePresenter::PicturePresenter()
    : m_program(sourceOf("present.vert", vertexText), sourceOf("present.frag", fragmentText)) {}

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
