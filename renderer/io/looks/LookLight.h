// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/Look.h"
#include "scene/light/Shading.h"

#include <optional>
#include <vector>

namespace limn {

/// Light as VTK's programs have it: a headlight of intensity 1 with white highlights, both sides lit, and
/// Phong's exponent of the reflected ray.
struct PhongLight {
  bool isOn = true;
  double ambient = 0.1;
  double diffuse = 0.9;
  double specular = 0.2;
  double power = 10.0;
};

/// The shading that draws the same, without loss: Limn has Phong's reflection, too. Numbers out of Limn's
/// limits are limited, with a sentence.
Shading shadingOf(const PhongLight& light, std::vector<Message>& changes);

/// The nearest such light, with a sentence for each thing that it cannot be. Absent shading gives VTK's usual
/// light.
PhongLight phongLightOf(const std::optional<Shading>& shading, std::vector<Message>& changes);

/// The exponent of Phong's reflected ray whose highlight is as wide as that of the half vector of Blinn-Phong
/// with `exponent`: a quarter, because the half vector turns by half the angle. And the other way round.
double phongExponent(double blinnExponent);
double blinnExponent(double phongExponent);

} // namespace limn
