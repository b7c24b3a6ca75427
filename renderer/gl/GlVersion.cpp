// SPDX-License-Identifier: GPL-3.0-or-later
#include "gl/GlVersion.h"

#include "scene/basics/Error.h"

#include <epoxy/gl.h>

namespace limn {

void requireOpenGl3() {
  if (epoxy_gl_version() < 30 || !epoxy_is_desktop_gl())
    throw Error(Error::Kind::openGl,
                "The graphics driver offers OpenGL " + std::to_string(epoxy_gl_version() / 10) + "." +
                    std::to_string(epoxy_gl_version() % 10) +
                    ", but drawing needs OpenGL 3.0; update the driver or install Mesa's "
                    "software driver (libgl1-mesa-dri).");
}

} // namespace limn
