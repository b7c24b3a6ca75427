// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"

namespace limn {

/// The definition itself in double precision, on `threads` of the processor (0: all). Needs no OpenGL.
std::unique_ptr<DrawingEngine> makeReferenceEngine(int threads = 0);

} // namespace limn
