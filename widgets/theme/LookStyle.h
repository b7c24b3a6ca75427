// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>
#include <QString>

class QApplication;

namespace limn {

/// Fusion with icons of our own set where Qt would draw its own (dialogs for files, the button for tools that
/// find no room), and none on the buttons of dialogs, whose texts say it.
class LookStyle : public QProxyStyle {
public:
  LookStyle();

  QIcon standardIcon(StandardPixmap icon, const QStyleOption* option, const QWidget* widget) const override;
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* answer) const override;
  int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
};

/// What the user asks for: `system` follows the platform's own lightness, and its high contrast.
enum class ThemeChoice { system, light, dark, contrast };

/// The choice called "light", "dark" or "contrast"; `system` for any other name.
ThemeChoice themeNamed(const QString& name);

/// Gives the whole program one look: LookStyle, palette and style sheet. `system` asks the platform anew at
/// every call, so call it again on QEvent::ApplicationPaletteChange or when the setting changes. Widgets of
/// ours repaint by themselves.
void applyTheme(QApplication& application, ThemeChoice choice);

} // namespace limn
