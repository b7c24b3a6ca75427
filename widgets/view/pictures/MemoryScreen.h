// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/pictures/PictureScreen.h"

namespace limn {

/// Pictures in memory, shown in an image of its own; for engines that compute in memory. Needs no OpenGL and
/// belongs to no thread. `isCancelled` ends drawing with Cancelled (renderer/engine); it may be empty.
std::unique_ptr<PictureScreen> makeMemoryScreen(std::function<bool()> isCancelled);

} // namespace limn
