// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/BrokenDriver.h"

#include <epoxy/gl.h>

#include <string>

namespace limn::test {
namespace {

PFNGLSHADERSOURCEPROC shaderSource = nullptr;
PFNGLGETGRAPHICSRESETSTATUSPROC resetStatus = nullptr;
PFNGLTEXIMAGE3DPROC texImage3D = nullptr;

// libepoxy finds the driver's function at its first call, through the pointer that stands for it.
void withBrokenLine(GLuint shader, GLsizei, const GLchar* const* text, const GLint*) {
  const std::string broken = std::string(*text) + "\n#error a line of a test\n";
  const char* lines = broken.c_str();
  epoxy_glShaderSource = shaderSource;
  glShaderSource(shader, 1, &lines, nullptr);
  shaderSource = epoxy_glShaderSource;
  epoxy_glShaderSource = withBrokenLine;
}

GLenum unknownReset() {
  return GL_UNKNOWN_CONTEXT_RESET;
}

void refusedTexture(GLenum, GLint, GLint, GLsizei, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*) {
  glEnable(GL_NONE); // leaves an error
}

} // namespace

BrokenShaders::BrokenShaders() {
  shaderSource = epoxy_glShaderSource;
  epoxy_glShaderSource = withBrokenLine;
}

BrokenShaders::~BrokenShaders() {
  epoxy_glShaderSource = shaderSource;
}

ResetDriver::ResetDriver() {
  resetStatus = epoxy_glGetGraphicsResetStatus;
  epoxy_glGetGraphicsResetStatus = unknownReset;
}

ResetDriver::~ResetDriver() {
  epoxy_glGetGraphicsResetStatus = resetStatus;
}

DriverWithoutTextures::DriverWithoutTextures() {
  texImage3D = epoxy_glTexImage3D;
  epoxy_glTexImage3D = refusedTexture;
}

DriverWithoutTextures::~DriverWithoutTextures() {
  epoxy_glTexImage3D = texImage3D;
}

void forgetRayCasterPrograms() {
  for (GLuint name = 1; name < 1000; ++name)
    if (glIsProgram(name) == GL_TRUE && glGetUniformLocation(name, "u_anchor") >= 0)
      glDeleteProgram(name);
}

} // namespace limn::test
