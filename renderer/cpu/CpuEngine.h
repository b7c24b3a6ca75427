// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"

namespace limn {

/// Draws on `threads` of the processor (0: all) in single precision. Needs no OpenGL.
std::unique_ptr<DrawingEngine> makeCpuEngine(int threads = 0);

} // namespace limn
