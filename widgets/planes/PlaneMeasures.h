// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneDrag.h"
#include "widgets/view/overlay/MeasureMarks.h"

#include <vector>

namespace limn {

/// Whether a measurement is seen in the slice that is shown: it was made in that plane, and all of it lies
/// within half a slice. A mark is seen in every plane through it.
bool isInSlice(const PlaneContent& content, PatientPlane plane, const Measurement& measurement);

/// What is seen of the measurements in a slice. An ellipse has five handles: its left, right, upper and lower
/// end, and its middle.
std::vector<MeasureShape> measureShapes(const PlaneContent& content, PatientPlane plane,
                                        const PlaneFrame& frame);

/// The corner of an ellipse that is drawn, beside its five handles.
inline constexpr std::size_t ellipseCorner = 5;

/// A measurement that begins at a place of a plane, with no extent yet. A mark has a free name.
Measurement begunAt(Measurement::Kind kind, PatientPlane plane, const glm::dvec3& placeMm,
                    const std::vector<Measured>& others);

/// The same measurement with a handle led to a place in its plane. While the corner of an angle is led that
/// has no second leg yet (`isNew`), its other end goes along: it is no angle before it has three places.
Measurement withHandleAt(Measurement measurement, std::size_t handle, const glm::dvec3& placeMm, bool isNew);

} // namespace limn
