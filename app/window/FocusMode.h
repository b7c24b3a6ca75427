// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

#include <vector>

class QAction;
class QMainWindow;
class QWidget;

namespace limn {

class Docks;
class FadingNote;

/// The picture and its curve without what stands around them: panels, tool bars and status bar go while the
/// action is checked, and those that were there before come back with it. A note over the picture says how.
class FocusMode : public QObject {
  Q_OBJECT

public:
  /// All outlive it.
  FocusMode(QMainWindow& window, Docks& docks, QAction& action);

  /// Brings everything back: a window is remembered as it is without this mode.
  void leave();

private:
  void set(bool isOn);

  QMainWindow& m_window;
  Docks& m_docks;
  QAction& m_action;
  FadingNote* m_note = nullptr;            ///< once there was something to say
  std::vector<QPointer<QWidget>> m_hidden; ///< beside the docks
};

} // namespace limn
