// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/scenes/RandomScene.h"

#include "scene/ProjectionFacts.h"
#include "scene/light/Shading.h"
#include "scene/steps/RayFrame.h"
#include "stability/scenes/SimpleScenes.h"

#include <algorithm>

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

constexpr std::uint64_t recipesPerBlock = 6;
constexpr std::uint64_t comparableRecipes = 2; // of them: a third of all seeds

// The choices that decide on programs; a seed fills in the numbers.
struct Recipe {
  bool isComparable = false;
  Projection projection = Projection::composite;
  LightChoices light;
  Fog::Mode fog = Fog::Mode::none;
  Preintegration preintegrated = Preintegration::automatic;
  bool jitters = false;
  bool hasGradientOpacity = false;
  bool isCropped = false;
  bool hasTolerance = false;
  bool hasRegion = false;
};

// Scatters small numbers, so that neighbours have nothing in common (splitmix64).
std::uint64_t scattered(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Every other recipe is a composite; the others take turns, so that few blocks hold them all.
Projection randomProjection(Dice& dice, std::uint64_t recipe) {
  static constexpr std::array others{Projection::mip,
                                     Projection::minip,
                                     Projection::average,
                                     Projection::xray,
                                     Projection::isosurface,
                                     Projection::isosurface,
                                     Projection::compositeIsosurface};
  return dice.oneIn(2) ? Projection::composite : others[recipe % others.size()];
}

Recipe recipeOf(std::uint64_t seed) {
  const std::uint64_t block = seed / seedsPerBlock;
  const std::uint64_t number = seed % recipesPerBlock;
  const std::uint64_t global = block * recipesPerBlock + number;
  Dice dice(scattered(global));
  Recipe recipe;
  recipe.isComparable = number < comparableRecipes;
  recipe.projection = randomProjection(dice, global);
  recipe.light = randomChoices(dice);
  recipe.fog = static_cast<Fog::Mode>(dice.oneIn(2) ? 0 : 1 + dice.upTo(3));
  recipe.preintegrated = static_cast<Preintegration>(dice.upTo(3));
  recipe.jitters = dice.oneIn(4);
  recipe.hasGradientOpacity = dice.oneIn(4);
  recipe.isCropped = dice.oneIn(3);
  recipe.hasTolerance = dice.oneIn(6);
  recipe.hasRegion = dice.oneIn(4);
  if (recipe.isComparable) {
    recipe.light.model = ShadingModel::none;
    recipe.hasGradientOpacity = false;
    recipe.hasTolerance = false;
    recipe.hasRegion = false;
    if (recipe.projection == Projection::isosurface || recipe.projection == Projection::compositeIsosurface)
      recipe.projection = Projection::composite;
  }
  return recipe;
}

// Any colour, often with channels of exactly 0 or 1.
glm::dvec3 randomColor(Dice& dice) {
  glm::dvec3 color = dice.vector(0.0, 1.0);
  for (int channel = 0; channel < 3; ++channel)
    if (dice.oneIn(4))
      color[channel] = dice.upTo(2);
  return color;
}

double randomOpacity(Dice& dice) {
  return dice.oneIn(3) ? 0.0 : dice.oneIn(8) ? 1.0 : dice.oneIn(3) ? dice.octaves(-40, 0) : dice.fraction();
}

// A value in the volume's range, at its ends, a little or far beyond, or at any number.
double randomValue(Dice& dice, const ValueRange& range) {
  const double width = range.highest - range.lowest;
  switch (dice.upTo(10)) {
  case 0:
    return range.lowest;
  case 1:
    return range.highest;
  case 2:
    return range.lowest + width * dice.between(-0.5, 1.5);
  case 3:
    return dice.sign() * dice.octaves(-1000, 1000);
  case 4:
    return range.lowest + width * dice.upTo(9) / 8.0;
  default:
    return range.lowest + width * dice.fraction();
  }
}

// 0 to 8 points; some at one value or so near that a float cannot tell.
TransferFunction randomFunction(Dice& dice, const Volume& volume) {
  TransferFunction function;
  const int points = dice.upTo(9);
  for (int i = 0; i < points; ++i) {
    double value = randomValue(dice, volume.range());
    if (i > 0 && dice.oneIn(4))
      value = function.points.back().value;
    if (i > 0 && dice.oneIn(8))
      value = std::nextafter(function.points.back().value, 1e300);
    function.points.push_back({value, randomColor(dice), randomOpacity(dice)});
  }
  return normalised(function);
}

// Points whose segments are wide enough that the rounding of a scalar moves no opacity by more than rounding.
TransferFunction gentleFunction(Dice& dice, const Volume& volume) {
  constexpr int places = 16;
  TransferFunction function;
  const ValueRange& range = volume.range();
  for (int place = 0; place <= places && function.points.size() < 8; ++place)
    if (dice.oneIn(3)) {
      const double value = range.lowest + (range.highest - range.lowest) * place / places;
      const double opacity = dice.oneIn(4) ? 0.0 : 0.98 * dice.fraction();
      function.points.push_back({value, randomColor(dice), opacity});
    }
  // A constant volume has one value: points at one place would be a step.
  if (!(range.highest > range.lowest) && function.points.size() > 1)
    function.points.resize(1);
  return normalised(function);
}

// Where pictures are compared, the box is at most 64 unit distances long: what the rounding of a scalar
// changes of an opacity counts as often.
double randomUnitDistance(Dice& dice, const Recipe& recipe, const Grid& grid) {
  const double diagonal = boxDiagonalMm(grid);
  if (recipe.isComparable)
    return diagonal * dice.octaves(-6, 4);
  if (dice.oneIn(16))
    return dice.octaves(-1000, 1000);
  return (dice.oneIn(2) ? smallestSpacingMm(grid) : diagonal) * dice.octaves(-20, 20);
}

Fog randomFog(Dice& dice, Fog::Mode mode, const Scene& scene) {
  const double size = boxDiagonalMm(scene.volume->grid());
  const glm::dvec3 eye = scene.camera.position - boxCentreMm(scene.volume->grid());
  const double away = std::abs(eye.x) + std::abs(eye.y) + std::abs(eye.z);
  Fog fog{mode, randomColor(dice), 0.0, 0.0, 0.0};
  fog.densityPerMm = dice.oneIn(8) ? 0.0 : dice.octaves(-6, 6) / size;
  fog.startMm = dice.oneIn(4) ? 0.0 : away * dice.between(0.5, 1.0) + size * dice.between(-1.0, 1.0);
  fog.endMm = dice.oneIn(6) ? fog.startMm : fog.startMm + size * dice.between(-0.2, 2.0);
  if (dice.oneIn(16))
    fog.densityPerMm = dice.octaves(-1000, 1000);
  if (dice.oneIn(16))
    fog.startMm = dice.sign() * dice.octaves(-1000, 1000);
  return fog;
}

CropBox randomCrop(Dice& dice) {
  CropBox crop;
  for (int axis = 0; axis < 3; ++axis) {
    if (dice.oneIn(2))
      crop.lower[axis] = dice.oneIn(4) ? 0.5 : dice.fraction();
    if (dice.oneIn(2))
      crop.upper[axis] = crop.lower[axis] + (1.0 - crop.lower[axis]) * dice.octaves(-20, 0);
    if (!(crop.lower[axis] < crop.upper[axis]))
      crop.upper[axis] = 1.0;
  }
  return crop;
}

// Two to four labels in cubes of any size; weights often of exactly 0 or 1.
Region randomRegion(Dice& dice, const glm::ivec3& dims) {
  std::vector<double> weights(static_cast<std::size_t>(2 + dice.upTo(3)));
  for (double& weight : weights)
    weight = dice.oneIn(2) ? dice.upTo(2) : dice.fraction();
  return cubesRegion(dims, 1 + dice.upTo(8), weights);
}

// Looks of any functions for some of its labels, from dice of their own: the other choices of a seed stay.
Region randomLooks(Dice& dice, const Region& region, const Volume& volume) {
  std::map<std::size_t, TransferFunction> looks;
  for (std::size_t place = 0; place < region.weights.size(); ++place)
    if (!dice.oneIn(3)) {
      looks[place] = randomFunction(dice, volume);
      looks[place].unitDistanceMm = randomUnitDistance(dice, {}, volume.grid());
    }
  return withLooks(region, looks);
}

// How many samples the longest ray takes: mostly few, sometimes one (a step longer than the box) or very
// many.
double randomSampleCount(Dice& dice) {
  switch (dice.upTo(16)) {
  case 0:
    return dice.octaves(-16, 0);
  case 1:
    return std::min(dice.octaves(9, 16), static_cast<double>(mostSamples));
  default:
    return dice.octaves(0, 9);
  }
}

double randomStep(Dice& dice, const Grid& grid) {
  static constexpr std::array usual{0.25, 0.5, 1.0, 2.0};
  const double longest = boxDiagonalMm(grid) / smallestSpacingMm(grid);
  const double step = longest / randomSampleCount(dice);
  const double usualStep = dice.oneOf(usual);
  const bool isUsual = dice.oneIn(3) && longest / usualStep < 512.0;
  // The largest step of a scene file.
  return std::min(isUsual ? usualStep : step, 1e6);
}

Quality randomQuality(Dice& dice, const Recipe& recipe, const Grid& grid) {
  Quality quality;
  quality.stepVoxels = randomStep(dice, grid);
  quality.preintegrated = recipe.preintegrated;
  quality.jitter = recipe.jitters;
  static constexpr std::array ends{0.5, 0.98, 0.998, 0.998, 0x1p-20, 1.0};
  quality.earlyTermination = recipe.isComparable && !dice.oneIn(4) ? 1.0 : dice.oneOf(ends);
  if (recipe.hasTolerance) {
    quality.toleranceLevels = dice.octaves(-3, 4);
    if (dice.oneIn(2))
      quality.fineness = 0.25 * dice.upTo(20);
  }
  return quality;
}

// Few pixels for many samples, so that a picture takes milliseconds.
glm::ivec2 randomSize(Dice& dice, double samples) {
  if (samples > 4000.0)
    return {3 + dice.upTo(4), 3};
  if (samples > 512.0)
    return {8 + dice.upTo(5), 8};
  return {12 + dice.upTo(21), 12 + dice.upTo(21)};
}

std::string describe(const RandomScene& random, const Recipe& recipe, const std::string& volume,
                     const std::string& camera) {
  const ShadingModel model = recipe.light.model;
  const Scene& scene = random.scene;
  return std::string(model == ShadingModel::none ? "unlit" : nameOf(model)) + " " + nameOf(scene.projection) +
         ", " + volume + ", " + camera + ", " + std::to_string(scene.transferFunction.points.size()) +
         " points, " + std::to_string(random.size.x) + "x" + std::to_string(random.size.y) + " pixels";
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

RandomScene randomScene(std::uint64_t seed) {
  const Recipe recipe = recipeOf(seed);
  Dice dice(scattered(~seed));
  const RandomVolume volume = recipe.isComparable ? exactVolume(dice) : randomVolume(dice);
  const Grid& grid = volume.volume->grid();
  RandomScene random;
  Scene& scene = random.scene;
  scene.volume = volume.volume;
  const RandomCamera camera = randomCamera(dice, grid);
  scene.camera = camera.camera;
  scene.transferFunction =
      recipe.isComparable ? gentleFunction(dice, *scene.volume) : randomFunction(dice, *scene.volume);
  scene.transferFunction.unitDistanceMm = randomUnitDistance(dice, recipe, grid);
  scene.shading = randomShading(dice, recipe.light, scene.volume->range(), grid);
  if (recipe.hasGradientOpacity)
    scene.gradientOpacity = randomGradientOpacity(dice, scene.volume->range(), grid);
  scene.fog = randomFog(dice, recipe.fog, scene);
  if (recipe.isCropped)
    scene.crop = randomCrop(dice);
  if (recipe.hasRegion)
    scene.keep = randomRegion(dice, grid.dims);
  if (Dice ofLooks(scattered(seed ^ 0x6c6f6f6b73u)); recipe.hasRegion && ofLooks.oneIn(2))
    scene.keep = randomLooks(ofLooks, scene.keep, *scene.volume);
  scene.projection = recipe.projection;
  scene.isovalue = randomValue(dice, scene.volume->range());
  scene.quality = randomQuality(dice, recipe, grid);
  const double samples = longestRaySamples(scene);
  random.size = randomSize(dice, samples);
  scene.image.width = random.size.x;
  scene.image.height = random.size.y;
  random.isComparable = recipe.isComparable;
  const bool blends = scene.projection == Projection::composite || scene.projection == Projection::xray;
  random.isSliceable = blends && !recipe.hasTolerance && samples <= 256.0 && scene.keep.looks.empty();
  random.description = describe(random, recipe, volume.description, camera.description);
  return random;
}

} // namespace limn
