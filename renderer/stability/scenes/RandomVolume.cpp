// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/scenes/RandomScene.h"

#include <limits>
#include <type_traits>

namespace limn {
namespace {

// A rotation from two random directions, by square roots alone.
glm::dmat3 randomRotation(Dice& dice) {
  const glm::dvec3 x = dice.direction();
  glm::dvec3 y = dice.direction();
  y -= glm::dot(x, y) * x;
  const double length = glm::length(y);
  if (!(length > 1e-3))
    return glm::dmat3(1.0);
  y /= length;
  return {x, y, glm::cross(x, y)};
}

// The grid's axes along the world's, in any order and direction.
glm::dmat3 randomAxes(Dice& dice) {
  glm::dmat3 axes(0.0);
  const int first = dice.upTo(3);
  const int turn = 1 + dice.upTo(2);
  for (int axis = 0; axis < 3; ++axis)
    axes[axis][(first + turn * axis) % 3] = dice.sign();
  return axes;
}

int randomDim(Dice& dice) {
  return dice.oneIn(6) ? 1 : dice.oneIn(4) ? 1 + dice.upTo(33) : 2 + dice.upTo(10);
}

template <class T>
T specialValue(Dice& dice) {
  using Limits = std::numeric_limits<T>;
  if constexpr (std::is_floating_point_v<T>) {
    const std::array<T, 10> values{Limits::quiet_NaN(),
                                   Limits::infinity(),
                                   -Limits::infinity(),
                                   Limits::max(),
                                   Limits::lowest(),
                                   std::numeric_limits<float>::max(),
                                   std::numeric_limits<float>::lowest(),
                                   Limits::denorm_min(),
                                   -Limits::min() / 2,
                                   T(-0.0)};
    return dice.oneOf(values);
  } else {
    const std::array<T, 4> values{Limits::max(), Limits::lowest(), T(0), T(1)};
    return dice.oneOf(values);
  }
}

// What the voxels of a volume look like.
enum class Pattern { noise, constant, wave, twoValues, narrow };

template <class T>
T ordinaryValue(Dice& dice, Pattern pattern, std::size_t index) {
  const double extent = std::is_floating_point_v<T> ? 1000.0 : 0.45 * std::numeric_limits<T>::max();
  const double centre = std::is_unsigned_v<T> ? 1.1 * extent : 0.0;
  switch (pattern) {
  case Pattern::noise:
    return static_cast<T>(centre + extent * dice.between(-1.0, 1.0));
  case Pattern::constant:
    return static_cast<T>(centre + 0.5 * extent);
  case Pattern::wave:
    return static_cast<T>(centre + extent * (static_cast<double>(index % 11) / 5.0 - 1.0));
  case Pattern::twoValues:
    return static_cast<T>(centre + (dice.oneIn(2) ? 0.25 : -0.25) * extent);
  case Pattern::narrow:
    // A few steps of the type around a large number.
    return static_cast<T>(centre + extent + dice.upTo(3));
  }
  return T(0);
}

template <class T>
std::vector<T> randomVoxels(Dice& dice, std::size_t count, std::string& description) {
  const auto pattern = static_cast<Pattern>(dice.upTo(5));
  const int specialShare = dice.oneIn(3) ? 1 << dice.upTo(8) : 0; // one voxel in so many
  std::vector<T> voxels(count);
  for (std::size_t i = 0; i < count; ++i)
    voxels[i] = specialShare > 0 && dice.oneIn(specialShare) ? specialValue<T>(dice)
                                                             : ordinaryValue<T>(dice, pattern, i);
  static constexpr const char* names[] = {"noise", "constant", "wave", "two values", "narrow"};
  description += names[static_cast<int>(pattern)];
  if (specialShare > 0)
    description += ", special 1/" + std::to_string(specialShare);
  return voxels;
}

VoxelArray randomArray(Dice& dice, std::size_t count, std::string& description) {
  switch (dice.upTo(8)) {
  case 0:
    return randomVoxels<std::uint8_t>(dice, count, description);
  case 1:
    return randomVoxels<std::int8_t>(dice, count, description);
  case 2:
    return randomVoxels<std::uint16_t>(dice, count, description);
  case 3:
    return randomVoxels<std::int16_t>(dice, count, description);
  case 4:
    return randomVoxels<std::uint32_t>(dice, count, description);
  case 5:
    return randomVoxels<std::int32_t>(dice, count, description);
  case 6:
    return randomVoxels<float>(dice, count, description);
  default:
    return randomVoxels<double>(dice, count, description);
  }
}

Rescale randomRescale(Dice& dice) {
  if (dice.oneIn(2))
    return {};
  Rescale rescale{dice.octaves(-4, 4) * dice.sign(), 0.0};
  if (dice.oneIn(8))
    rescale.slope = dice.oneIn(4) ? 0.0 : dice.octaves(-60, 60);
  if (dice.oneIn(2))
    rescale.intercept = dice.sign() * dice.octaves(-2, dice.oneIn(4) ? 40 : 12);
  return rescale;
}

std::string describe(const Grid& grid, const VoxelArray& voxels) {
  return std::to_string(grid.dims.x) + "x" + std::to_string(grid.dims.y) + "x" + std::to_string(grid.dims.z) +
         " " + voxelTypeName(voxels) + " ";
}

std::size_t voxelCount(const Grid& grid) {
  return static_cast<std::size_t>(grid.dims.x) * grid.dims.y * grid.dims.z;
}

} // namespace

Grid randomGrid(Dice& dice) {
  Grid grid;
  for (int axis = 0; axis < 3; ++axis)
    grid.dims[axis] = randomDim(dice);
  const double size = dice.oneIn(3) ? 1.0 : dice.octaves(-20, 20);
  const int apart = dice.oneIn(4) ? 12 : 2;
  for (int axis = 0; axis < 3; ++axis)
    grid.spacingMm[axis] = size * (dice.oneIn(2) ? 1.0 : dice.octaves(-apart / 2, apart / 2));
  grid.direction = dice.oneIn(3) ? glm::dmat3(1.0) : dice.oneIn(2) ? randomAxes(dice) : randomRotation(dice);
  if (dice.oneIn(3))
    grid.direction[2] = -grid.direction[2];
  if (!dice.oneIn(4))
    grid.originMm = size * dice.octaves(-2, dice.oneIn(4) ? 24 : 6) * dice.vector(-1.0, 1.0);
  return grid;
}

RandomVolume randomVolume(Dice& dice) {
  const Grid grid = randomGrid(dice);
  std::string pattern;
  const VoxelArray voxels = randomArray(dice, voxelCount(grid), pattern);
  const Rescale rescale = randomRescale(dice);
  std::optional<PaddingRange> padding;
  if (dice.oneIn(4)) {
    const double first = dice.oneIn(2) ? 0.0 : dice.between(-200.0, 200.0);
    padding = PaddingRange{first, first + (dice.oneIn(2) ? 0.0 : dice.octaves(0, 7))};
  }
  return {std::make_shared<const Volume>(grid, voxels, rescale, padding, VolumeInfo{}),
          describe(grid, voxels) + pattern};
}

RandomVolume exactVolume(Dice& dice) {
  const Grid grid = randomGrid(dice);
  const int kind = dice.upTo(5); // constant, three ramps, product
  const glm::dvec3 slope = dice.vector(-1.0, 1.0);
  const glm::dvec3 last = glm::max(glm::dvec3(grid.dims - 1), 1.0);
  std::vector<double> voxels;
  voxels.reserve(voxelCount(grid));
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const glm::dvec3 place = glm::dvec3(i, j, k) / last;
        voxels.push_back(kind == 0 ? 0.25 : kind == 4 ? place.x * place.y * place.z : glm::dot(slope, place));
      }
  const Rescale rescale{dice.octaves(-10, 12) * dice.sign(), dice.between(-1000.0, 1000.0)};
  VoxelArray stored = std::move(voxels);
  if (dice.oneIn(3)) {
    const auto& doubles = std::get<StoredVoxels<double>>(stored);
    stored = std::vector<float>(doubles.begin(), doubles.end());
  }
  const char* name = kind == 0 ? "constant" : kind == 4 ? "product" : "ramp";
  const std::string description = describe(grid, stored) + name;
  return {std::make_shared<const Volume>(grid, std::move(stored), rescale, std::nullopt, VolumeInfo{}),
          description};
}

} // namespace limn
