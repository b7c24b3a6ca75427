// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <array>

namespace limn {

/// Whether samples along a ray are classified one by one and add up to its pixel.
constexpr bool integrates(Projection projection) {
  return projection == Projection::composite || projection == Projection::xray ||
         projection == Projection::compositeIsosurface;
}

/// Whether near samples hide far ones, so that a ray can end early.
constexpr bool composites(Projection projection) {
  return integrates(projection) && projection != Projection::xray;
}

/// Whether a surface of the scene's isovalue is shown.
constexpr bool showsSurface(Projection projection) {
  return projection == Projection::isosurface || projection == Projection::compositeIsosurface;
}

/// Whether every sample is looked at, and one value of the ray is classified.
constexpr bool classifiesOnce(Projection projection) {
  return !integrates(projection) && !showsSurface(projection);
}

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
