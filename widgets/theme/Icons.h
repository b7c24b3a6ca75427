// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QPalette>
#include <QString>

namespace limn {

/// An icon of our own set, its strokes in the palette's text colour, in the accent where it is switched on,
/// and faded where disabled; sharp at every size. `name` is a file's in widgets/theme/icons: "open". Make
/// icons anew when the palette changes (QEvent::PaletteChange).
QIcon themedIcon(const QString& name, const QPalette& palette);

/// The program's own, in colours that no theme changes.
QIcon programIcon();

} // namespace limn
