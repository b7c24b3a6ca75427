// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace limn {

/// Throws Error (openGl) naming the version where the current context is older than OpenGL 3.0.
void requireOpenGl3();

} // namespace limn
