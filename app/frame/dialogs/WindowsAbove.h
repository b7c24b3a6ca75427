// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

namespace limn {

/// Keeps dialogs and floating panels above their window where Qt makes that anew for the display, as it does
/// once OpenGL draws a part of it for the first time: they would lie behind it and no longer belong to it.
class WindowsAbove : public QObject {
  Q_OBJECT

public:
  /// Belongs to the window.
  explicit WindowsAbove(QWidget& window);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void raiseAll(const QPointer<QWidget>& withKeyboard);

  QWidget& m_window;
};

} // namespace limn
