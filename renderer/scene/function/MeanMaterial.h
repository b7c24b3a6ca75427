// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"

namespace limn {

/// What a transfer function holds between two values, as one pre-integrated step sees it.
struct MeanMaterial {
  double extinction = 0.0; ///< mean, per unit distance
  glm::dvec3 color{0.0};   ///< mean, weighted by the extinction; 0 where nothing absorbs
};

/// The mean over all values between `a` and `b`, in either order (DEFINITION section 7): exact, piece by
/// linear piece, from closed forms of the integrals of -log(1-a). Depends on no step.
MeanMaterial meanMaterial(const TransferFunction& function, double a, double b);

/// The means of colour times extinction (rgb) and of extinction per unit distance (a) over a stretch along
/// which opacity and colour change linearly.
glm::dvec4 meanOfPiece(const Classified& from, const Classified& to);

} // namespace limn
