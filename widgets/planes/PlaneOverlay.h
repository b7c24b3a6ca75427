// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneDrag.h"
#include "widgets/view/overlay/MeasureMarks.h"
#include "widgets/view/overlay/OrientationMarks.h"
#include "widgets/view/overlay/OverlayParts.h"

#include <QPolygonF>

#include <optional>
#include <vector>

namespace limn {

/// What stands above a slice, ready to be painted; places in logical pixels.
struct PlaneOverlay {
  QRectF view;
  QFont font;
  QPointF crosshair;
  bool hasCrosshair = true; ///< and its value among the notes
  QPolygonF crop;           ///< where the crop box is cut; empty: nowhere
  QString title, window;    ///< plane and place, and the window of grey values, as they stand among the notes
  std::vector<Note> notes;  ///< with the value under the crosshair
  std::optional<ScaleMark> scale;
  std::optional<LetterMarks> letters; ///< none where sides are unknown
  std::vector<MeasureMark> measures;  ///< what was measured in it
};

/// Of a slice in a view of this size.
PlaneOverlay planeOverlay(const PlaneContent& content, PatientPlane plane, const PlaneFrame& frame,
                          const QSizeF& size, const QFont& font);

/// What a tool tip says at a point: all of a note that is shortened, and all that is known of a measurement
/// whose text lies there; empty for nothing.
QString planeToolTip(const PlaneOverlay& overlay, const PlaneContent& content, const QPointF& point);

/// Paints it in the logical pixels of the view.
void paintPlaneOverlay(QPainter& painter, const PlaneOverlay& overlay);

} // namespace limn
