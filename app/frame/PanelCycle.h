// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>

class QWidget;

namespace limn {

class ActionList;

/// Takes the keyboard from panel to panel, F6 forwards and Shift+F6 back, past those that are not seen; each
/// goes on where it was left.
class PanelCycle : public QObject {
  Q_OBJECT

public:
  /// Through `panels` in order, one within another named after it. All outlive it.
  PanelCycle(ActionList& actions, const QList<QWidget*>& panels);

private:
  struct Panel {
    QWidget* area;
    QPointer<QWidget> last; ///< in it that had the keyboard
  };

  Panel* panelOf(const QWidget* widget);
  void note(QWidget* now);
  void step(int direction);

  QList<Panel> m_panels;
};

} // namespace limn
