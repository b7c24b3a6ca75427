// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/pictures/PictureScreen.h"

namespace limn {

/// Pictures in textures, shown in the framebuffer that is bound when the screen is cleared. Needs the same
/// OpenGL context current for every call and the end of all that it made. Throws Error (openGl).
std::unique_ptr<PictureScreen> makeGlScreen();

} // namespace limn
