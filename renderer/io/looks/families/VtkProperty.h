// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/Look.h"
#include "io/looks/curves/CurvedSegments.h"
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

/// What a volume property of VTK holds, as programs on it save it in several ways. The points of each curve
/// are in the order of the file; of opacity and gradient opacity only the opacity counts, of colour only the
/// colour.
struct VtkProperty {
  std::string name; ///< empty: the file's
  std::vector<BentPoint> opacity;
  std::vector<BentPoint> color;
  std::vector<BentPoint> gradientOpacity; ///< over value per voxel; no points: none
  bool gradientOpacityIsOff = false;
  HeadLight light;
  std::optional<double> unitDistanceMm; ///< over which opacities hold; absent: the file cannot say
};

/// The look as Limn shows it. `file` is how sentences call it, `index` its place there. What `changes` tells
/// already comes first. Throws Error (input).
ReadLook lookOf(VtkProperty property, const std::string& file, std::size_t index,
                const std::optional<LookTarget>& target, std::vector<Message> changes);

/// The nearest property. Where the format `holdsUnitDistance`, opacities stay as they are.
VtkProperty vtkPropertyOf(const Preset& preset, bool holdsUnitDistance,
                          const std::optional<LookTarget>& target, std::vector<Message>& changes);

/// "CT" or another modality where the first word of a name says so, as those of most presets do.
std::string modalityIn(const std::string& name);

/// Said of formats that do not tell over which length their opacities hold.
inline const Message oneMillimetreTaken =
    Message::tr("The file does not say over which length its opacities hold; 1 mm was taken.");

} // namespace limn
