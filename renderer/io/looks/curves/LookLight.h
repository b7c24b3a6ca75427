// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/Look.h"
#include "scene/light/Shading.h"

#include <optional>
#include <vector>

namespace limn {

/// Light as most programs have it: a headlight of intensity 1 with white highlights that lights both sides.
/// VTK's programs reflect after Phong.
struct HeadLight {
  bool isOn = true;
  double ambient = 0.1;
  double diffuse = 0.9;
  double specular = 0.2;
  double exponent = 10.0; ///< of the reflection
  Reflection reflection = Reflection::phong;
};

/// The shading that draws the same, without loss: Limn has both reflections. Numbers out of Limn's limits are
/// limited, with a sentence.
Shading shadingOf(const HeadLight& light, std::vector<Message>& changes);

/// The nearest such light that reflects in the way asked for, with a sentence for each thing that it cannot
/// be. Absent shading gives VTK's usual light.
HeadLight headLightOf(const std::optional<Shading>& shading, Reflection reflection,
                      std::vector<Message>& changes);

/// The exponent of Phong's reflected ray whose highlight is as wide as that of the half vector of Blinn-Phong
/// with `exponent`: a quarter, because the half vector turns by half the angle. And the other way round.
double phongExponent(double blinnExponent);
double blinnExponent(double phongExponent);

} // namespace limn
