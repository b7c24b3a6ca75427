// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/Scene.h"

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <string>

namespace limn {

/// Random numbers that are the same on every machine: the generator is defined bit by bit, and numbers are
/// made of its bits without the distributions and functions of a library, which may round otherwise.
class Dice {
public:
  explicit Dice(std::uint64_t seed) : m_generator(seed) {}

  std::uint64_t bits() { return m_generator(); }

  /// 0 ≤ x < 1.
  double fraction() { return std::ldexp(static_cast<double>(m_generator() >> 11), -53); }
  double between(double low, double high) { return low + (high - low) * fraction(); }

  /// 2^first ≤ x < 2^last, each octave as likely as another.
  double octaves(int first, int last) { return std::ldexp(1.0 + fraction(), first + upTo(last - first)); }

  /// 0, 1, … count - 1.
  int upTo(int count) { return static_cast<int>(m_generator() % static_cast<std::uint64_t>(count)); }
  bool oneIn(int count) { return upTo(count) == 0; }
  double sign() { return oneIn(2) ? 1.0 : -1.0; }

  glm::dvec3 vector(double low, double high) {
    const double x = between(low, high);
    const double y = between(low, high);
    return {x, y, between(low, high)};
  }

  /// A vector of unit length, each direction possible.
  glm::dvec3 direction() {
    const glm::dvec3 v = vector(-1.0, 1.0);
    const double length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    return length > 0.0 ? v / length : glm::dvec3(1.0, 0.0, 0.0);
  }

  template <class T, std::size_t count>
  const T& oneOf(const std::array<T, count>& values) {
    return values[static_cast<std::size_t>(upTo(static_cast<int>(count)))];
  }

private:
  std::mt19937_64 m_generator;
};

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
