// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/regions/Region.h"

namespace limn {

/// What stands for a label in lists and legends, so that one looks as it does in the picture: the colour that
/// its file gives it, or, of one with a curve of its own, the mean colour of its voxels by that, each as much
/// as the curve makes it opaque, of some thousand of them (where it makes all of them transparent, of all
/// alike). `place` is one of the region's own labels.
glm::dvec3 shownColor(const Volume& volume, const Region& region, std::size_t place);

} // namespace limn
