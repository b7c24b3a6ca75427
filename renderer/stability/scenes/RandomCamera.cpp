// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/scenes/RandomScene.h"

#include <algorithm>
#include <array>

namespace limn {
namespace {

// A place of the box in fractions of it, 0 and 1 its faces.
glm::dvec3 placeIn(const Grid& grid, const glm::dvec3& fractions) {
  return indexToWorld(grid, fractions * glm::dvec3(grid.dims) - 0.5);
}

glm::dvec3 randomCorner(Dice& dice) {
  const double x = dice.upTo(2);
  const double y = dice.upTo(2);
  return {x, y, static_cast<double>(dice.upTo(2))};
}

// One of the grid's axes, in the world.
glm::dvec3 randomAxis(Dice& dice, const Grid& grid) {
  return dice.sign() * grid.direction[dice.upTo(3)];
}

glm::dvec3 viewDirection(Dice& dice, const Grid& grid) {
  if (dice.oneIn(3))
    return randomAxis(dice, grid);
  if (dice.oneIn(4)) {
    // Along a diagonal of the box or of one of its faces.
    const glm::dvec3 diagonal = placeIn(grid, randomCorner(dice)) - placeIn(grid, randomCorner(dice));
    if (glm::length(diagonal) > 0.0)
      return diagonal / glm::length(diagonal);
  }
  return dice.direction();
}

glm::dvec3 randomUp(Dice& dice, const Grid& grid, const glm::dvec3& forward) {
  switch (dice.upTo(8)) {
  case 0:
    return forward;
  case 1:
    return glm::dvec3(0.0);
  case 2:
    return dice.direction() * dice.octaves(-900, 900);
  case 3:
    return forward + dice.octaves(-60, -10) * dice.direction();
  case 4:
  case 5:
    return randomAxis(dice, grid);
  default:
    return dice.direction();
  }
}

enum class Stand { outside, face, edge, corner, inside, voxel, far, beyond };
constexpr std::array standNames{"outside", "on a face",  "on an edge", "on a corner",
                                "inside",  "on a voxel", "far",        "beyond all"};

glm::dvec3 eyeAt(Dice& dice, const Grid& grid, Stand stand) {
  glm::dvec3 place = dice.vector(0.0, 1.0);
  const glm::dvec3 corner = randomCorner(dice);
  const int axis = dice.upTo(3);
  if (stand == Stand::face)
    place[axis] = corner[axis];
  if (stand == Stand::edge)
    place = {corner.x, corner.y, place.z};
  if (stand == Stand::corner)
    place = corner;
  if (stand == Stand::voxel)
    place = (glm::floor(place * glm::dvec3(grid.dims)) + 0.5) / glm::dvec3(grid.dims);
  return placeIn(grid, place);
}

// From a place in the box outwards, for eyes outside.
Camera standingOff(Dice& dice, const Grid& grid, double diagonals) {
  Camera camera;
  camera.target = dice.oneIn(2) ? boxCentreMm(grid) : placeIn(grid, dice.vector(0.0, 1.0));
  camera.position = camera.target - viewDirection(dice, grid) * (diagonals * boxDiagonalMm(grid));
  return camera;
}

// A field of view or height that shows the box, or a little or much of it.
void setLens(Dice& dice, const Grid& grid, double diagonalsAway, Camera& camera) {
  const double shown = dice.oneIn(2) ? 1.2 : dice.octaves(-4, 3);
  camera.heightMm = dice.oneIn(12) ? dice.octaves(-80, 80) : shown * boxDiagonalMm(grid);
  // Degrees of a box seen from so far, as long as they are few.
  const double fitting = 57.0 * shown / std::max(diagonalsAway, 0.3);
  const bool isAny = dice.oneIn(6);
  camera.fovYDeg = isAny ? dice.between(1e-6, 170.0) : std::clamp(fitting, 1e-6, 170.0);
}

} // namespace

RandomCamera randomCamera(Dice& dice, const Grid& grid) {
  static constexpr std::array stands{Stand::outside, Stand::outside, Stand::outside, Stand::outside,
                                     Stand::face,    Stand::edge,    Stand::corner,  Stand::inside,
                                     Stand::voxel,   Stand::far,     Stand::far,     Stand::beyond};
  const Stand stand = dice.oneOf(stands);
  const double diagonalsAway = stand == Stand::outside  ? dice.octaves(0, 3)
                               : stand == Stand::far    ? dice.octaves(6, 30)
                               : stand == Stand::beyond ? dice.octaves(30, 900)
                                                        : 0.0;
  Camera camera;
  if (diagonalsAway > 0.0) {
    camera = standingOff(dice, grid, diagonalsAway);
  } else {
    camera.position = eyeAt(dice, grid, stand);
    camera.target = camera.position + viewDirection(dice, grid) * boxDiagonalMm(grid);
    if (dice.oneIn(3))
      camera.target = boxCentreMm(grid);
  }
  const bool isOnTarget = dice.oneIn(40);
  if (isOnTarget)
    camera.target = camera.position;
  camera.projection = dice.oneIn(2) ? Camera::Projection::orthographic : Camera::Projection::perspective;
  setLens(dice, grid, diagonalsAway, camera);
  const glm::dvec3 forward = basisOf(camera).forward;
  camera.up = randomUp(dice, grid, forward);
  const bool isParallel = camera.projection == Camera::Projection::orthographic;
  return {camera, std::string(isParallel ? "orthographic " : "perspective ") +
                      standNames[static_cast<std::size_t>(stand)] + (isOnTarget ? ", on its target" : "")};
}

} // namespace limn
