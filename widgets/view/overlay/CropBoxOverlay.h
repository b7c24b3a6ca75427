// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/CropBoxGeometry.h"
#include "widgets/view/overlay/OverlayParts.h"
#include "widgets/view/overlay/OverlaySource.h"

#include <Qt>

#include <optional>
#include <vector>

class QPainter;

namespace limn {

/// The crop box over one picture.
struct CropBoxOverlay {
  QRectF picture;
  CropBoxShape shape;
  std::optional<CropFace> lively; ///< the face whose handle is hovered or held
  std::optional<Note> note;       ///< what that face is called and cuts off
};

/// One for each picture that the box stands over; empty where it is not shown.
std::vector<CropBoxOverlay> cropBoxesOf(const OverlaySource& source);

/// The crop box as it stands over the picture at `position`.
CropBoxShape cropShapeAt(const Comparison& comparison, const ViewGeometry& geometry, int position);

/// The handle that a press at `point` takes hold of.
std::optional<CropHandle> cropHandleAt(const OverlaySource& source, const QPointF& point);

/// Paints the crop box over a picture: light lines on dark ones, so that they show on any picture; what lies
/// behind the box is dimmer. `lively` is the face whose handle is hovered or held.
void paintCropBox(QPainter& painter, const CropBoxShape& shape, const std::optional<CropFace>& lively);

/// The pointer for a handle: two arrows along the way its face moves.
Qt::CursorShape cursorFor(const CropHandle& handle);

} // namespace limn
