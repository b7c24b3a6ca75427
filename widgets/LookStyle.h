// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProxyStyle>

namespace limn {

/// Fusion with icons of our own set where Qt would draw its own (dialogs for files), and none on the buttons
/// of dialogs, whose texts say it.
class LookStyle : public QProxyStyle {
public:
  LookStyle();

  QIcon standardIcon(StandardPixmap icon, const QStyleOption* option, const QWidget* widget) const override;
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* answer) const override;
};

} // namespace limn
