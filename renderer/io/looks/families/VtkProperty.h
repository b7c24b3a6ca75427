// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/curves/CurvedSegments.h"
#include "io/looks/curves/LookLight.h"

namespace limn {

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
