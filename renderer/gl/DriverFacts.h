// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace limn {

/// What a bug report needs to know of the current context's driver.
struct DriverFacts {
  std::string renderer;
  std::string version;
  std::string shadingLanguage;
  int largest3dTexture = 0; ///< texels along an edge
  bool tellsOfResets = false;
};

/// Asks the current context.
DriverFacts driverFacts();

/// Throws Error (openGl) naming the version where the current context is older than OpenGL 3.0.
void requireOpenGl3();

} // namespace limn
