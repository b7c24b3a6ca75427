// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/looks/Look.h"

#include <optional>
#include <vector>

namespace limn {

/// Gradient opacity as VTK's programs have it, in value per mean voxel spacing, in Limn's value/mm. Without a
/// target, voxels of 1 mm are taken, and said. Absent where the curve is 1 throughout. `curve` ascends in
/// value, which is the gradient; only its opacity counts.
std::optional<GradientOpacity> gradientOpacityFromVtk(const std::vector<ControlPoint>& curve,
                                                      const std::optional<LookTarget>& target,
                                                      std::vector<Message>& changes);

/// The other way round: points of gradient and opacity; (0, 1) and (255, 1), as such programs write it, where
/// there is no gradient opacity.
std::vector<GradientOpacityPoint> gradientOpacityForVtk(const std::optional<GradientOpacity>& opacity,
                                                        const std::optional<LookTarget>& target,
                                                        std::vector<Message>& changes);

/// A function whose values are relative, 0 to 1, stretched over the range of the target, which is said.
/// Without one it stays as it is, which is said too.
TransferFunction stretchedOver(const TransferFunction& function, const std::optional<LookTarget>& target,
                               std::vector<Message>& changes);

/// The function with opacities over 1 mm, for formats that hold no length, within 0.01 between points; said
/// where that changes them.
TransferFunction overOneMillimetre(const TransferFunction& function, std::vector<Message>& changes);

/// Sentences for what only Limn's own files hold of a preset beside curves and light: projection, landmarks.
void tellLostParts(const Preset& preset, std::vector<Message>& changes);

} // namespace limn
