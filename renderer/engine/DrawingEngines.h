// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

namespace limn {

class DrawingEngine;

using MakeEngine = std::function<std::unique_ptr<DrawingEngine>()>;

/// What a view draws with, chosen by the program.
struct DrawingEngines {
  MakeEngine driver;    ///< draws in strips while the graphics driver works; called with its context current
  MakeEngine processor; ///< draws in memory when the driver has failed; may be empty: then a sentence says so
};

} // namespace limn
