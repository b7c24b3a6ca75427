// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QRect;
class QWidget;

namespace limn {

/// Shows a pop-up window under `anchor` (global pixels), or above it where the screen ends; always on the
/// screen.
void showPopupAt(QWidget& popup, const QRect& anchor);

} // namespace limn
