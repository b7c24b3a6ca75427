// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QSurfaceFormat>

namespace limn {

/// The OpenGL surface the views ask for: 3.1 with the deprecated functions, which drivers answer with a
/// compatibility profile (asking for 3.0 gives Mesa's core profile, which need not accept GLSL 1.30); no
/// depth buffer, no multisampling. The program may also make it the default format before its first window.
QSurfaceFormat limnSurfaceFormat();

/// What this computer offers the windows of the program.
struct OpenGlOffer {
  QString problem;  ///< one sentence where there is no OpenGL 3.0; empty where there is
  QString renderer; ///< the driver's name of what draws
};

/// Tries, on the thread of the windows. Ask before making a view that draws with OpenGL: a window with a
/// QOpenGLWidget crashes inside Qt where no context can be made.
OpenGlOffer openGlOffer();

} // namespace limn
