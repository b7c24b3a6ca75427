// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/DriverFacts.h"

#include "gl/HeadlessContext.h"
#include "scene/basics/Error.h"

#include <epoxy/gl.h>

namespace limn {
namespace {

std::string textOf(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "unknown";
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
                    .arg(epoxy_gl_version() / 10)
                    .arg(epoxy_gl_version() % 10));
}

} // namespace limn
