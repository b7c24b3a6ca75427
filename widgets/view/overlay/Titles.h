// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/view/overlay/OverlayParts.h"
#include "widgets/view/overlay/OverlaySource.h"

#include <optional>
#include <vector>

namespace limn {

/// A label and where it stands.
struct PlacedLabel {
  SideLabel label;
  QRectF plate;
  QRectF steadyPlate; ///< while its numbers show: what yields to a label must not jump when they fade
};

/// The labels of the pictures, by position.
std::vector<PlacedLabel> labelsOf(const OverlaySource& source);

/// What a picture of a difference is called, and what it means.
struct DifferenceTitle {
  PlacedLabel label;
  Note note;
};

/// In the middle, under the models' labels where it does not fit between them; absent in other layouts.
std::optional<DifferenceTitle> differenceTitleOf(const OverlaySource& source);

/// The position of the label under a point that leads to a menu; -1 for none.
int labelAt(const OverlaySource& source, const QPointF& point);

/// What a tool tip says at a point; empty for nothing.
QString toolTipAt(const OverlaySource& source, const QPointF& point);

} // namespace limn
