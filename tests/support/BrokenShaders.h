// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <epoxy/gl.h> // include this file before any OpenGL header of Qt

#include <string>

namespace limn::test {

/// While it lives, every shader gets a line that the driver's own compiler refuses: "a line of a test".
class BrokenShaders {
public:
  BrokenShaders() {
    driver() = epoxy_glShaderSource;
    epoxy_glShaderSource = withBrokenLine;
  }
  ~BrokenShaders() { epoxy_glShaderSource = driver(); }
  BrokenShaders(const BrokenShaders&) = delete;
  BrokenShaders& operator=(const BrokenShaders&) = delete;

private:
  static PFNGLSHADERSOURCEPROC& driver() {
    static PFNGLSHADERSOURCEPROC function = nullptr;
    return function;
  }

  // libepoxy finds the driver's function at its first call, through the pointer that stands for it.
  static void withBrokenLine(GLuint shader, GLsizei, const GLchar* const* text, const GLint*) {
    const std::string broken = std::string(*text) + "\n#error a line of a test\n";
    const char* lines = broken.c_str();
    epoxy_glShaderSource = driver();
    glShaderSource(shader, 1, &lines, nullptr);
    driver() = epoxy_glShaderSource;
    epoxy_glShaderSource = withBrokenLine;
  }
};

} // namespace limn::test
