// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

class QMenu;
class QToolBar;

namespace limn {

/// Adds a button that opens a menu to a tool bar.
QToolButton* addMenuButton(QToolBar& bar, QMenu* menu, QToolButton::ToolButtonPopupMode mode);

} // namespace limn
