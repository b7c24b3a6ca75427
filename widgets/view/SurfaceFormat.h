// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSurfaceFormat>

namespace limn {

/// The OpenGL surface the views ask for: 3.1 with the deprecated functions, which drivers answer with a
/// compatibility profile (asking for 3.0 gives Mesa's core profile, which need not accept GLSL 1.30); no
/// depth buffer, no multisampling. The program may also make it the default format before its first window.
QSurfaceFormat limnSurfaceFormat();

} // namespace limn
