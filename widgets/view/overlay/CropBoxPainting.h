// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/CropBoxGeometry.h"

#include <Qt>

class QPainter;

namespace limn {

/// Paints the crop box over a picture: light lines on dark ones, so that they show on any picture; what lies
/// behind the box is dimmer. `lively` is the face whose handle is hovered or held.
void paintCropBox(QPainter& painter, const CropBoxShape& shape, const std::optional<CropFace>& lively);

/// The pointer for a handle: two arrows along the way its face moves.
Qt::CursorShape cursorFor(const CropHandle& handle);

} // namespace limn
