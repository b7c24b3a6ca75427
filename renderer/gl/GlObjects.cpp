// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/GlObjects.h"

#include <epoxy/gl.h>

namespace limn {

unsigned TextureKind::create() {
  GLuint name = 0;
  glGenTextures(1, &name);
  return name;
}
void TextureKind::destroy(unsigned name) {
  glDeleteTextures(1, &name);
}

unsigned BufferKind::create() {
  GLuint name = 0;
  glGenBuffers(1, &name);
  return name;
}
void BufferKind::destroy(unsigned name) {
  glDeleteBuffers(1, &name);
}

unsigned VertexArrayKind::create() {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  return name;
}
void VertexArrayKind::destroy(unsigned name) {
  glDeleteVertexArrays(1, &name);
}

unsigned FramebufferKind::create() {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  return name;
}
void FramebufferKind::destroy(unsigned name) {
  glDeleteFramebuffers(1, &name);
}

unsigned ProgramKind::create() {
  return glCreateProgram();
}
void ProgramKind::destroy(unsigned name) {
  glDeleteProgram(name);
}

unsigned QueryKind::create() {
  GLuint name = 0;
  glGenQueries(1, &name);
  return name;
}
void QueryKind::destroy(unsigned name) {
  glDeleteQueries(1, &name);
}

} // namespace limn
