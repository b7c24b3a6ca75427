// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

#include <glm/glm.hpp>

namespace limn {

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
  QColor histogramEdge; ///< its upper edge, which tells its shape; contrast ≥ 3:1 under any curve
  QColor curve;         ///< the opacity curve
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

/// A scene's display colour (sRGB-encoded, 0..1) as Qt paints it.
inline QColor toQColor(const glm::dvec3& color) {
  const glm::dvec3 c = glm::clamp(color, 0.0, 1.0);
  return QColor::fromRgbF(static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b));
}

/// A picked colour as the scene keeps it: 8 bits per channel, as hex codes write them.
inline glm::dvec3 toSceneColor(const QColor& color) {
  return glm::dvec3(color.red(), color.green(), color.blue()) / 255.0;
}

} // namespace limn
