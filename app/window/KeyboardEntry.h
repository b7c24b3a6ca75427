// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace limn {

/// Whether a widget takes the keyboard from Tab at the moment.
bool takesKeys(const QWidget& widget);

/// Where the keyboard enters an area that it was never in: its focus proxy, or the first in it that takes the
/// keyboard from Tab; null where nothing does.
QWidget* keyboardEntryOf(QWidget& area);

} // namespace limn
