// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/volume/Volume.h"
#include "stability/scenes/Dice.h"

#include <memory>
#include <string>

namespace limn {

/// A volume and what it is made of, in words for a reader.
struct RandomVolume {
  std::shared_ptr<const Volume> volume;
  std::string description;
};

/// 1 to 33 voxels along each axis, spacings from 2⁻²⁰ to 2²⁰ mm (about 1e-6 to 1e6), equal or up to 2¹²
/// apart, in any orientation, mirrored ones included, near the origin or far from it.
Grid randomGrid(Dice& dice);

/// A volume of any stored type, of random, constant or wavy voxels, some of them special: NaN, ±Inf, the
/// type's extremes, denormals, declared padding; with offsets and slopes up to huge and negative ones. Throws
/// Error (input) where no voxel is valid.
RandomVolume randomVolume(Dice& dice);

/// A volume whose field trilinear interpolation reproduces exactly, up to the voxels' rounding: a constant, a
/// ramp or a product of coordinates.
RandomVolume exactVolume(Dice& dice);

} // namespace limn
