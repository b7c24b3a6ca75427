// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace limn {

class Actions;

/// Lists what mouse and keys do, and the keys of the menus' actions, in a box that blocks nothing.
void showShortcuts(const Actions& actions, QWidget* parent);

/// Says what Limn is, in a box that blocks nothing.
void showAbout(QWidget* parent);

} // namespace limn
