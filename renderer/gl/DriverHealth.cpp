// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/DriverHealth.h"

#include "gl/HeadlessContext.h"

#include <epoxy/gl.h>

#include <cstdio>

namespace limn {
namespace {

std::string textOf(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "unknown";
}

// A driver keeps at most a flag for each kind of error, and there are eight.
constexpr int mostFlags = 16;

constexpr GLenum contextLostError = 0x0507; // GL_CONTEXT_LOST of KHR_robustness

// The function under whichever name the driver has it; none where the driver cannot tell of resets.
GLenum resetStatus() {
  if (epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness"))
    return glGetGraphicsResetStatus();
  if (epoxy_has_gl_extension("GL_ARB_robustness"))
    return glGetGraphicsResetStatusARB();
  return GL_NO_ERROR;
}

std::string hexadecimal(GLenum value) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%04x", static_cast<unsigned>(value));
  return text;
}

} // namespace

DriverFacts driverFacts() {
  DriverFacts facts{rendererName(), textOf(GL_VERSION), textOf(GL_SHADING_LANGUAGE_VERSION), 0, false};
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &facts.largest3dTexture);
  if (epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_ARB_robustness") ||
      epoxy_has_gl_extension("GL_KHR_robustness")) {
    GLint strategy = GL_NO_RESET_NOTIFICATION_ARB;
    glGetIntegerv(GL_RESET_NOTIFICATION_STRATEGY_ARB, &strategy);
    facts.tellsOfResets = strategy == GL_LOSE_CONTEXT_ON_RESET_ARB;
  }
  return facts;
}

void requireOpenGl3() {
  if (epoxy_gl_version() < 30 || !epoxy_is_desktop_gl())
    throw Error(Error::Kind::openGl,
                Message::tr("The graphics driver offers OpenGL %1.%2, but drawing needs OpenGL 3.0; update "
                            "the driver or install Mesa's software driver (libgl1-mesa-dri).")
                    .arg(epoxy_gl_version() / 10, epoxy_gl_version() % 10));
}

void forgetDriverErrors() {
  for (int i = 0; i < mostFlags && glGetError() != GL_NO_ERROR; ++i) {
  }
}

bool contextIsLost() {
  return resetStatus() != GL_NO_ERROR;
}

void requireHealthyDriver(const Message& doing) {
  const GLenum error = glGetError();
  if (error != GL_NO_ERROR)
    forgetDriverErrors();
  if (error == contextLostError || contextIsLost())
    throw DriverError(
        Message::tr("The graphics driver was reset while %1; try again, and if it happens often, draw with a "
                    "larger step, in a smaller picture or with --engine cpu.")
            .arg(doing),
        "graphics reset");
  if (error == GL_OUT_OF_MEMORY)
    throw DriverError(Message::tr("The graphics driver ran out of memory while %1; close other programs that "
                                  "draw, choose a smaller picture or use --engine cpu.")
                          .arg(doing),
                      "OpenGL error " + hexadecimal(error));
  if (error != GL_NO_ERROR)
    throw DriverError(Message::tr("The graphics driver refused a command while %1; update the driver or use "
                                  "--engine cpu, and please report it with `limn info --system`.")
                          .arg(doing),
                      "OpenGL error " + hexadecimal(error));
}

} // namespace limn
