// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/function/TransferFunction.h"

namespace limn {

class TransferFunctionCanvas;

/// Makes assistive technology find the control points in every plot: each a slider along the values, in their
/// unit, at its place in the plot, with a slider of its own for the opacity.
void makeCanvasesAccessible();

/// Says which points changed since `before`, came or went.
void tellPoints(TransferFunctionCanvas& canvas, const TransferFunction& before);

/// Says which point has the focus, where the plot has it and a point is in hand.
void tellPointFocus(TransferFunctionCanvas& canvas);

/// The same behind Qt's own word that the whole plot has the focus.
void tellPointFocusSoon(TransferFunctionCanvas& canvas);

} // namespace limn
