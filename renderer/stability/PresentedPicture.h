// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "stability/Workbench.h"

#include <cstdint>

namespace limn {

/// A picture over a background as the window puts it on the screen, in a framebuffer of 8 bits a channel;
/// rows from the top. Needs a current context.
std::vector<glm::u8vec4> presented(const DrawnPicture& picture, const glm::dvec3& background);

} // namespace limn
