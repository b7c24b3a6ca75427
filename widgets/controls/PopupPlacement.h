// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>

class QWidget;

namespace limn {

/// Where a pop-up of this size belongs to `anchor` without covering it: below, above, right or left, the
/// first that has room on `screen`. Where none has, it lies at the edge of the screen that is farther from
/// the anchor. All in one system of pixels.
QRect popupPlace(const QSize& size, const QRect& anchor, const QRect& screen);

/// Shows a pop-up there; `anchor` in global pixels.
void showPopupAt(QWidget& popup, const QRect& anchor);

} // namespace limn
