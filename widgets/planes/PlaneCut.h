// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/regions/Cut.h"
#include "widgets/planes/PlaneDrag.h"
#include "widgets/view/overlay/CutLine.h"

namespace limn {

/// The scissors that a line on a slice makes, which was drawn on the whole view (`line.picture`): under an
/// orthographic camera that looks along the slice's normal as the slice is looked at, from before the volume
/// and at the slice, and through all of it. There is a volume.
Scissors scissorsOn(const PlaneContent& content, const PlaneFrame& frame, const CutLine& line,
                    bool removesInside);

/// The depths between which such scissors cut where they cut the slab alone that is shown, at least one
/// slice.
glm::dvec2 slabDepthMm(const PlaneContent& content, PatientPlane plane, const Scissors& scissors);

} // namespace limn
