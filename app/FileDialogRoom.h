// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QFileDialog;

namespace limn {

/// Gives a dialog for files room for whole dates and for the places at its left; nothing where the platform
/// draws the dialog itself.
void giveRoom(QFileDialog& dialog);

} // namespace limn
