// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/view/Camera.h"
#include "stability/scenes/Dice.h"

#include <string>

namespace limn {

/// A camera and where it stands, in words for a reader.
struct RandomCamera {
  Camera camera;
  std::string description;
};

/// A camera outside the box, on one of its faces, edges or corners, inside it or far away, perspective
/// (fields of view from 1e-6 to 170 degrees) or orthographic, along the grid's axes or across them, on
/// voxels, now and then with an `up` along the view, without length or huge, or with its eye on its target.
RandomCamera randomCamera(Dice& dice, const Grid& grid);

} // namespace limn
