// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QSurfaceFormat>

namespace limn {

/// The OpenGL surface the views ask for: 3.1 with the deprecated functions, which drivers answer with a
/// compatibility profile (asking for 3.0 gives Mesa's core profile, which need not accept GLSL 1.30); no
/// depth buffer, no multisampling. The program may also make it the default format before its first window.
QSurfaceFormat limnSurfaceFormat();

/// One sentence where this computer offers the program no OpenGL 3.0, empty where it does. Ask before making
/// a view: a window with a QOpenGLWidget crashes inside Qt where no context can be made.
QString openGlProblem();

} // namespace limn
