// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/view/PicturePresenter.h"

#include "scene/Error.h"

#include <epoxy/gl.h>

#include <string>

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
out vec4 o_color;
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
  o_color = vec4(color, 1.0);
}
)";

unsigned compiled(GLenum stage, const char* text) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  return shader;
}

unsigned linked() {
  const GLuint vertex = compiled(GL_VERTEX_SHADER, vertexText);
  const GLuint fragment = compiled(GL_FRAGMENT_SHADER, fragmentText);
  const GLuint program = glCreateProgram();
  glAttachShader(program, vertex);
  glAttachShader(program, fragment);
  glBindFragDataLocation(program, 0, "o_color");
  glLinkProgram(program);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint ok = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &ok);
  if (ok)
    return program;
  std::string log(2000, '\0');
  GLsizei length = 0;
  glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
  glDeleteProgram(program);
  throw Error(Error::Kind::openGl, "The graphics driver refused the shader that shows pictures (" +
                                       log.substr(0, length) +
                                       "); install a driver with OpenGL 3.0 or newer.");
}

} // namespace

PicturePresenter::PicturePresenter() : m_program(linked()) {
  m_left = glGetUniformLocation(m_program, "u_left");
  m_right = glGetUniformLocation(m_program, "u_right");
  m_background = glGetUniformLocation(m_program, "u_background");
  m_gain = glGetUniformLocation(m_program, "u_gain");
  glGenVertexArrays(1, &m_vertexArray);
}

PicturePresenter::~PicturePresenter() {
  glDeleteProgram(m_program);
  glDeleteVertexArrays(1, &m_vertexArray);
}

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
  glUseProgram(m_program);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, right);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, left);
  glUniform1i(m_left, 0);
  glUniform1i(m_right, 1);
  glUniform3f(m_background, static_cast<float>(background.r), static_cast<float>(background.g),
              static_cast<float>(background.b));
  glUniform1f(m_gain, static_cast<float>(gain));
  glBindVertexArray(m_vertexArray);
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
