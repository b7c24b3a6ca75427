// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QWidget;

namespace limn {

/// Lists what mouse and keys do, in a box that blocks nothing.
void showShortcuts(QWidget* parent);

/// Says what Limn is, in a box that blocks nothing.
void showAbout(QWidget* parent);

} // namespace limn
