// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

namespace limn {

/// The word for a projection in scene files and in messages.
inline const char* nameOf(Projection projection) {
  constexpr const char* names[] = {"composite",           "mip", "minip", "average", "xray", "isosurface",
                                   "composite_isosurface"};
  return names[static_cast<int>(projection)];
}

} // namespace limn
