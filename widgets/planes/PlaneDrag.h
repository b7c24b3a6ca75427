// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "planes/PlaneGrid.h"
#include "widgets/MeasureText.h"
#include "widgets/planes/PlaneContent.h"
#include "widgets/view/overlay/MeasureMarks.h"

#include <QPointF>
#include <QSizeF>
#include <Qt>

#include <optional>

namespace limn {

/// A part of a plane that somebody chose to see; without it all of the grid is seen.
struct PlaneZoom {
  glm::dvec3 centreMm{0.0}; ///< world, in the middle of the view
  double mmPerPixel = 1.0;  ///< logical pixels, > 0
  bool operator==(const PlaneZoom&) const = default;
};

/// A plane as it lies in a view: a pixel of its grid is a device pixel, and the grid fills the view.
struct PlaneFrame {
  PlaneGrid grid;
  double pixelRatio = 1.0; ///< device pixels per logical one, each way
};

/// The frame of a view of this size (logical pixels, at least 1 each way) through a place in the world, which
/// shows all of a grid, or what was chosen.
PlaneFrame planeFrame(const Grid& seen, PatientPlane plane, const glm::dvec3& throughMm, const QSizeF& size,
                      double pixelRatio, const std::optional<PlaneZoom>& zoom);

/// The same of a picture that has `scale` > 0 times as many pixels each way.
PlaneFrame scaledBy(PlaneFrame frame, double scale);

/// The same about the same middle in a picture of another shape (pixels): its height shows as much as before,
/// its width what fits. Logical pixels stay as large in it, of whichever side has become smaller.
PlaneFrame shapedAs(PlaneFrame frame, const glm::ivec2& size);

/// Between the world and points of the view, logical pixels. What is seen at a point lies in the plane.
QPointF pointOf(const PlaneFrame& frame, const glm::dvec3& worldMm);
glm::dvec3 worldAt(const PlaneFrame& frame, const QPointF& point);

/// The same along both axes of the view.
double mmPerLogicalPixel(const PlaneFrame& frame);

/// What is seen after zooming by `factor` > 1 (nearer) or < 1 about a point of the view, or after dragging it
/// by logical pixels. From a hundredth of a millimetre to a metre per pixel.
PlaneZoom zoomedAbout(const PlaneFrame& frame, const QPointF& point, double factor);
PlaneZoom pannedBy(const PlaneFrame& frame, const QPointF& moved);

/// What the left button does in slices. Scissors and piece cut by hand, in picture and slices alike; the last
/// four measure, in the order of Measurement::Kind.
enum class PlaneTool { crosshair, windowLevel, scissors, piece, distance, angle, ellipse, mark };

/// Whether it is one of the two that cut by hand.
bool cuts(PlaneTool tool);

/// What a tool measures, where it does, and the tool that measures so.
std::optional<Measurement::Kind> kindOf(PlaneTool tool);
PlaneTool toolOf(Measurement::Kind kind);

/// The tool that a key takes, with the keyboard in a slice or beside it: C, W, X, K, D, G, E, N.
std::optional<PlaneTool> toolOfKey(int key);

/// Of a click the pointer moves by less than this, logical pixels.
inline constexpr double shortestDrag = 3.0;

/// A drag in a slice, as it began.
struct PlaneDrag {
  enum class Kind { crosshair, windowLevel, pan, measure };
  Kind kind = Kind::crosshair;
  Qt::MouseButton button = Qt::LeftButton;
  QPointF press;        ///< logical pixels
  PlaneSettings before; ///< as they were at the press
  PlaneContent content; ///< what the drag goes on from
  PlaneFrame frame;
  // Of `measure`:
  std::vector<Measurement> measurements = {}; ///< with one that it makes
  MeasureHandle handle = {};                  ///< that it leads; of an ellipse it makes `ellipseCorner`
  bool isNew = false;                         ///< it makes one
  bool isLoose = false;                       ///< the handle follows the pointer until the next press
  Gesture gesture = {};
};

/// A press in the view of a plane.
struct PlanePress {
  PatientPlane plane = PatientPlane::axial;
  PlaneTool tool = PlaneTool::crosshair;
  Qt::MouseButton button = Qt::LeftButton;
  Qt::KeyboardModifiers modifiers;
  QPointF point;
};

/// The handle of a measurement that a press with the left button takes: one at this point, logical pixels,
/// but with a tool that makes measurements of another kind, which draws there.
std::optional<MeasureHandle> handleTaken(const PlaneContent& content, PatientPlane plane,
                                         const PlaneFrame& frame, PlaneTool tool, const QPointF& point);

/// The drag that a press begins: the middle button, or the left one with Shift, pans; the right one, or the
/// left one with Alt as in the 3D picture, drags the window; the left one takes the handle that it is on
/// (handleTaken), else does what the tool says. Nothing for other buttons.
std::optional<PlaneDrag> dragFrom(const PlanePress& press, const PlaneContent& content,
                                  const PlaneFrame& frame);

/// The settings after a drag to a point; nothing where it changes none (pan, measure).
std::optional<PlaneSettings> settingsAfter(const PlaneDrag& drag, const QPointF& point);

/// The measurements after a drag to a point that measures, and those before it.
MeasurementsEdited measuredAfter(const PlaneDrag& drag, const QPointF& point);
MeasurementsEdited measuredBefore(const PlaneDrag& drag);

/// The measurements after its button is let go at a point, of a drag that makes one. The drag is loose from
/// then on where places are still to come: after a click the next is clicked, as in the picture, and of an
/// angle the second leg follows the first.
MeasurementsEdited measuredAtRelease(PlaneDrag& drag, const QPointF& point);

} // namespace limn
