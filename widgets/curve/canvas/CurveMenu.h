// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QPointF;

namespace limn {

class TransferFunctionCanvas;

/// Opens the menu of a plot at a place in it: what can be done with the point there or, beside all points, at
/// that place, and with all points. A point that is not in hand comes into it.
void openCurveMenu(TransferFunctionCanvas& canvas, const QPointF& position);

} // namespace limn
