// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cpu/bricks/BrickRenderer.h"

namespace limn {

/// The picture of a scene, drawn brick by brick in this process and folded as ranks would fold it. Every
/// brick ends its rays for itself: with early termination at e each leaves out at most the share 1 - e of
/// what shines through it. Throws Error.
Image drawInBricks(const Scene& scene, const glm::ivec2& size, int bricks, int threads = 0);

} // namespace limn
