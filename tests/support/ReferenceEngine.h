// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "engine/DrawingEngine.h"

namespace limn::test {

/// The definition itself as an engine, in double precision, on `threads` of the processor (0: all). Needs no
/// OpenGL.
std::unique_ptr<DrawingEngine> makeReferenceEngine(int threads = 0);

} // namespace limn::test
