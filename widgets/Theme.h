// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

class QApplication;

namespace limn {

/// What the user asks for: `system` follows the platform's own lightness, and its high contrast.
enum class ThemeChoice { system, light, dark, contrast };

/// The choice called "light", "dark" or "contrast"; `system` for any other name.
ThemeChoice themeNamed(const QString& name);

/// A designed look. `contrast` is for eyes that see little: white and yellow on black, every line visible.
enum class Look { light, dark, contrast };

/// The colours of one look. The palette carries the roles Qt knows; our own painting takes the rest here.
struct ThemeColors {
  QColor window;        ///< behind panels
  QColor base;          ///< behind text entry, lists and plots
  QColor raised;        ///< buttons
  QColor hover;         ///< a button or row under the pointer
  QColor border;        ///< hairlines between parts
  QColor grid;          ///< hairlines in a plot
  QColor text;          ///< contrast with window, base and raised ≥ 7:1
  QColor secondaryText; ///< units, hints, axis labels; contrast ≥ 4.5:1
  QColor disabledText;  ///< contrast with window and base ≥ 4.5:1: it still says something
  QColor accent;        ///< the one accent: focus, selection, handles
  QColor accentText;    ///< on the accent
  QColor outline;       ///< around what is typed in or pressed, tracks of sliders; contrast ≥ 3:1
  QColor histogram;     ///< filled area behind the curve, quiet so that curve and marks stand out from it
  QColor
      histogramEdge; ///< its upper edge, which tells its shape; contrast ≥ 3:1 under any colour of the curve
  QColor curve;      ///< the opacity curve
};

/// The designed colours of a look.
ThemeColors themeColors(Look look);

/// The colours that belong to a palette made by themePalette, or the nearer look for any other palette.
ThemeColors themeColors(const QPalette& palette);

/// The look that a palette made by themePalette belongs to, or the nearer of light and dark.
Look lookOf(const QPalette& palette);

/// The palette of the whole window in that look.
QPalette themePalette(Look look);

/// Rounded hairline controls on a 4-px grid, as a Qt style sheet.
QString themeStyleSheet(Look look);

/// True where a palette's windows are darker than its text.
bool isDark(const QPalette& palette);

/// Registers the icons and the style sheet of this library: a linker drops a static library's resources
/// unless somebody asks for them. Cheap to call again.
void loadWidgetResources();

/// Gives the whole program one look: Fusion with our own icons (LookStyle), palette and style sheet. `system`
/// asks the platform anew at every call, so call it again on QEvent::ApplicationPaletteChange or when the
/// setting changes. Widgets of ours repaint by themselves.
void applyTheme(QApplication& application, ThemeChoice choice);

} // namespace limn
