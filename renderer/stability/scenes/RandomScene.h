// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"
#include "stability/scenes/Dice.h"

#include <cstdint>
#include <memory>
#include <string>

namespace limn {

/// A scene that a seed chose.
struct RandomScene {
  Scene scene;
  glm::ivec2 size{16, 16}; ///< pixels
  /// Unlit, without surface, its field reproduced exactly between voxels and its control points well apart:
  /// the double-precision reference must agree with every renderer within rounding.
  bool isComparable = false;
  bool isSliceable = false; ///< composite or X-ray with few enough steps for the slice renderer
  std::string description;  ///< one line for a reader
};

/// Seeds are drawn in blocks of so many: a block shares a few choices of effects, so that a renderer compiles
/// few programs for it. Over many blocks every combination comes up.
inline constexpr std::uint64_t seedsPerBlock = 192;

/// The scene of a seed, the same on every machine (HARD_CASES section 5): volume, camera, 0 to 8 control
/// points, light, fog, crop, projection and quality within what a scene file may say, at and beyond what
/// anybody would choose; its rays take at most 60000 samples. Throws Error (input) where the volume drawn is
/// one that Volume refuses.
RandomScene randomScene(std::uint64_t seed);

/// A camera and where it stands, in words for a reader.
struct RandomCamera {
  Camera camera;
  std::string description;
};

/// A camera outside the box, on one of its faces, edges or corners, inside it or far away, perspective
/// (fields of view from 1e-6 to 170 degrees) or orthographic, along the grid's axes or across them, on
/// voxels, now and then with an `up` along the view, without length or huge, or with its eye on its target.
RandomCamera randomCamera(Dice& dice, const Grid& grid);

/// The choices of a lighting model that decide on programs.
struct LightChoices {
  ShadingModel model = ShadingModel::classic;
  Reflection reflection = Reflection::blinn;
  SpecularColor specularColor = SpecularColor::material;
  GradientCurve::Type curve = GradientCurve::Type::linear;
  bool twoSided = false;
  bool isFixed = false; ///< light of a direction of its own
};

/// Any model, reflection, colour, curve and light.
LightChoices randomChoices(Dice& dice);

/// The numbers of a lighting model within what a scene file may say: coefficients from 0 to huge, exponents
/// to 1024, opacity coefficients to 8, ranges that may be one number, references from tiny to huge.
Shading randomShading(Dice& dice, const LightChoices& choices, const ValueRange& range, const Grid& grid);

/// 0 to 5 points in ascending order, some at one modulus, around the moduli that the volume may have.
GradientOpacity randomGradientOpacity(Dice& dice, const ValueRange& range, const Grid& grid);

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
