// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability/scenes/RandomScene.h"

#include <algorithm>

namespace limn {
namespace {

// Neutral, usual or extreme.
double randomCoefficient(Dice& dice) {
  switch (dice.upTo(10)) {
  case 0:
    return 0.0;
  case 1:
    return 1.0;
  case 2:
    return dice.octaves(-1000, 1000);
  default:
    return dice.octaves(-4, 2);
  }
}

double randomExponent(Dice& dice) {
  return dice.oneIn(8) ? 1024.0 : dice.oneIn(8) ? dice.octaves(-60, 0) : dice.octaves(0, 9);
}

// Two numbers in ascending order, sometimes one twice.
CoefficientRange ordered(Dice& dice, double a, double b) {
  if (dice.oneIn(6))
    b = a;
  return {std::min(a, b), std::max(a, b)};
}

double randomFactor(Dice& dice) {
  return dice.oneIn(4) ? 1.0 : dice.oneIn(6) ? 0.0 : dice.oneIn(6) ? 8.0 : dice.between(0.0, 8.0);
}

// The largest modulus that a volume of this range and spacing can hold, or about it.
double steepestModulus(const ValueRange& range, const Grid& grid) {
  return std::max(range.highest - range.lowest, 1e-300) / smallestSpacingMm(grid);
}

GradientReference randomReference(Dice& dice, const ValueRange& range, const Grid& grid) {
  switch (dice.upTo(5)) {
  case 0:
    return LargestReference{};
  case 1:
    return PercentileReference{dice.oneIn(4) ? 100.0 : std::max(1e-9, 100.0 * dice.fraction())};
  case 2:
    return FixedReference{dice.oneIn(4) ? dice.octaves(-1000, 1000)
                                        : steepestModulus(range, grid) * dice.octaves(-6, 2)};
  default:
    return AutomaticReference{};
  }
}

void setRobust(Dice& dice, Shading& shading) {
  shading.energyFactor = !dice.oneIn(3);
  if (dice.oneIn(3)) {
    const double low = dice.fraction();
    shading.significance = Significance{low, low + (1.0 - low) * dice.octaves(-30, 0)};
    if (!(shading.significance->low < shading.significance->high))
      shading.significance.reset();
  }
  if (dice.oneIn(4))
    shading.significance.reset();
  if (dice.oneIn(3))
    shading.knee = 0.999 * dice.fraction();
  if (dice.oneIn(4))
    shading.knee.reset();
}

} // namespace

LightChoices randomChoices(Dice& dice) {
  LightChoices choices;
  choices.model = static_cast<ShadingModel>(dice.upTo(4));
  choices.reflection = dice.oneIn(3) ? Reflection::phong : Reflection::blinn;
  choices.specularColor = dice.oneIn(3) ? SpecularColor::light : SpecularColor::material;
  choices.curve = static_cast<GradientCurve::Type>(dice.upTo(3));
  choices.twoSided = dice.oneIn(3);
  choices.isFixed = dice.oneIn(2);
  return choices;
}

Shading randomShading(Dice& dice, const LightChoices& choices, const ValueRange& range, const Grid& grid) {
  Shading shading;
  shading.model = choices.model;
  shading.reflection = choices.reflection;
  shading.specularColor = choices.specularColor;
  shading.twoSided = choices.twoSided;
  for (double* coefficient : {&shading.ambient, &shading.diffuse, &shading.specular,
                              &shading.ambientIntensity, &shading.lightIntensity})
    *coefficient = randomCoefficient(dice);
  shading.exponent = randomExponent(dice);
  const double first = randomExponent(dice);
  shading.exponentRange = ordered(dice, first, randomExponent(dice));
  const double least = randomFactor(dice);
  shading.opacityRange = ordered(dice, least, randomFactor(dice));
  shading.gradientReference = randomReference(dice, range, grid);
  shading.gradientCurve = {choices.curve, dice.oneIn(8) ? dice.octaves(-1000, 1000) : dice.octaves(-3, 6)};
  setRobust(dice, shading);
  // A light along the view, against it, on an axis, or with a length far from 1.
  if (choices.isFixed)
    shading.lightDirection = dice.oneIn(4)   ? glm::dvec3(grid.direction[dice.upTo(3)])
                             : dice.oneIn(4) ? dice.direction() * dice.octaves(-900, 900)
                                             : dice.direction();
  return shading;
}

GradientOpacity randomGradientOpacity(Dice& dice, const ValueRange& range, const Grid& grid) {
  GradientOpacity curve;
  const int points = dice.upTo(6);
  double modulus = 0.0;
  for (int i = 0; i < points; ++i) {
    const double opacity = dice.oneIn(3) ? 0.0 : dice.oneIn(3) ? 1.0 : dice.fraction();
    curve.points.push_back({modulus, opacity});
    if (!dice.oneIn(4))
      modulus += steepestModulus(range, grid) * dice.octaves(-8, 0);
  }
  return curve;
}

} // namespace limn
