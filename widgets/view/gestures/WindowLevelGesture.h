// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"
#include "scene/volume/Volume.h"

#include <QPointF>

namespace limn {

/// The window of a transfer function: the values between its outermost points.
struct FunctionWindow {
  double level = 0.0; ///< the middle, scalar units
  double width = 0.0; ///< ≥ 0
};

/// The window of a function; that of `range` where the function has no two different values.
FunctionWindow windowOf(const TransferFunction& function, const ValueRange& range);

/// The function after a window/level drag of `moved` logical pixels (y down) from where the drag began:
/// 256 pixels to the right widen it e-fold about its middle, 256 pixels up raise it by its whole width (the
/// width before the drag). Always computed from the function at the start, so that dragging back undoes.
TransferFunction windowLevelDragged(const TransferFunction& start, const ValueRange& range,
                                    const QPointF& moved);

/// The function after an opacity drag: 100 pixels up double every opacity. Zero stays zero.
TransferFunction opacityDragged(const TransferFunction& start, const QPointF& moved);

} // namespace limn
