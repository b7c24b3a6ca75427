// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/GlObjects.h"

#include <epoxy/gl.h>

namespace limn {

unsigned madeName(GlKind kind) {
  if (kind == GlKind::program)
    return glCreateProgram();
  const auto make = {glGenTextures, glGenBuffers, glGenVertexArrays, glGenFramebuffers, glGenQueries};
  GLuint name = 0;
  make.begin()[static_cast<int>(kind)](1, &name);
  return name;
}

void endName(GlKind kind, unsigned name) {
  if (kind == GlKind::program)
    return glDeleteProgram(name);
  const auto end = {glDeleteTextures, glDeleteBuffers, glDeleteVertexArrays, glDeleteFramebuffers,
                    glDeleteQueries};
  end.begin()[static_cast<int>(kind)](1, &name);
}

} // namespace limn
