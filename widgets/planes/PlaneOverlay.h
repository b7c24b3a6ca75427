// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/planes/PlaneContent.h"
#include "widgets/planes/PlaneDrag.h"
#include "widgets/view/overlay/OrientationMarks.h"
#include "widgets/view/overlay/OverlayParts.h"

#include <QPolygonF>

#include <optional>
#include <vector>

namespace limn {

/// What stands above a slice, ready to be painted; places in logical pixels.
struct PlaneOverlay {
  struct Distance {
    QPointF from, to;
    Note note;
  };

  QRectF view;
  QFont font;
  QPointF crosshair;
  QPolygonF crop;          ///< where the crop box is cut; empty: nowhere
  std::vector<Note> notes; ///< title and place first
  std::optional<ScaleMark> scale;
  std::optional<LetterMarks> letters; ///< none where sides are unknown
  std::optional<Distance> distance;
};

/// Of a slice in a view of this size.
PlaneOverlay planeOverlay(const PlaneContent& content, PatientPlane plane, const PlaneFrame& frame,
                          const QSizeF& size, const QFont& font);

/// Whether a measured distance lies in the slice that is shown: both ends within half a slice of it.
bool isInSlice(const PlaneContent& content, PatientPlane plane, const MeasuredDistance& distance);

/// Paints it in the logical pixels of the view.
void paintPlaneOverlay(QPainter& painter, const PlaneOverlay& overlay);

} // namespace limn
