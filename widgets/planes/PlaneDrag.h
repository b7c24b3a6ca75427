// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneFrame.h"

#include <Qt>

#include <optional>

namespace limn {

/// What the left button does in slices.
enum class PlaneTool { crosshair, windowLevel, distance };

/// A drag in a slice, as it began.
struct PlaneDrag {
  enum class Kind { crosshair, windowLevel, pan, distanceFrom, distanceTo };
  Kind kind = Kind::crosshair;
  Qt::MouseButton button = Qt::LeftButton;
  QPointF press;        ///< logical pixels
  PlaneSettings before; ///< as they were at the press
  PlaneContent content; ///< what the drag goes on from: a new distance has its first end
  PlaneFrame frame;
};

/// A press in the view of a plane.
struct PlanePress {
  PatientPlane plane = PatientPlane::axial;
  PlaneTool tool = PlaneTool::crosshair;
  Qt::MouseButton button = Qt::LeftButton;
  Qt::KeyboardModifiers modifiers;
  QPointF point;
};

/// The drag that a press begins: the middle button, or the left one with Shift, pans; the right one, or the
/// left one with Alt as in the 3D picture, drags the window; the left one takes an end of the measured
/// distance that it is on, else does what the tool says. Nothing for other buttons.
std::optional<PlaneDrag> dragFrom(const PlanePress& press, const PlaneContent& content,
                                  const PlaneFrame& frame);

/// The settings after a drag to a point; nothing where it changes none (pan).
std::optional<PlaneSettings> settingsAfter(const PlaneDrag& drag, const QPointF& point);

/// The end of the distance shown in the slice that a point is on.
std::optional<PlaneDrag::Kind> distanceEndAt(const PlaneContent& content, PatientPlane plane,
                                             const PlaneFrame& frame, const QPointF& point);

} // namespace limn
