// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/light/Shading.h"
#include "scene/volume/Grid.h"
#include "scene/volume/Volume.h"
#include "stability/scenes/Dice.h"

namespace limn {

/// The choices of a lighting model that decide on programs.
struct LightChoices {
  ShadingModel model = ShadingModel::classic;
  Reflection reflection = Reflection::blinn;
  SpecularColor specularColor = SpecularColor::material;
  GradientCurve::Type curve = GradientCurve::Type::linear;
  bool twoSided = false;
  bool isFixed = false; ///< light of a direction of its own
};

LightChoices randomChoices(Dice& dice);

/// The numbers of a lighting model within what a scene file may say: coefficients from 0 to huge, exponents
/// to 1024, opacity coefficients to 8, ranges that may be one number, references from tiny to huge.
Shading randomShading(Dice& dice, const LightChoices& choices, const ValueRange& range, const Grid& grid);

/// 0 to 5 points in ascending order, some at one modulus, around the moduli that the volume may have.
GradientOpacity randomGradientOpacity(Dice& dice, const ValueRange& range, const Grid& grid);

} // namespace limn
