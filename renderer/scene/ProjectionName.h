// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <array>

namespace limn {

/// Every projection, in the order in which they are offered.
inline constexpr std::array projections{Projection::composite,
                                        Projection::mip,
                                        Projection::minip,
                                        Projection::average,
                                        Projection::xray,
                                        Projection::isosurface,
                                        Projection::compositeIsosurface};

/// The word for a projection in scene files and in messages.
inline const char* nameOf(Projection projection) {
  constexpr std::array names{"composite",           "mip", "minip", "average", "xray", "isosurface",
                             "composite_isosurface"};
  return names[static_cast<std::size_t>(projection)];
}

} // namespace limn
