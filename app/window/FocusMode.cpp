// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/FocusMode.h"

#include "app/window/Docks.h"
#include "app/window/FadingNote.h"

#include <QAction>
#include <QMainWindow>
#include <QStatusBar>
#include <QToolBar>

#include <utility>

namespace limn {

FocusMode::FocusMode(QMainWindow& window, Docks& docks, QAction& action)
    : QObject(&window), m_window(window), m_docks(docks), m_action(action) {
  connect(&action, &QAction::toggled, this, &FocusMode::set);
}

void FocusMode::leave() {
  m_action.setChecked(false);
}

// What the user had closed before stays closed.
void FocusMode::set(bool isOn) {
  if (!isOn) {
    if (m_note)
      m_note->hide();
    for (const QPointer<QWidget>& bar : std::exchange(m_hidden, {}))
      if (bar)
        bar->show();
    return m_docks.showAgain();
  }
  m_docks.hideAllButCurve();
  const auto hide = [this](QWidget* bar) {
    if (bar->isHidden())
      return;
    m_hidden.emplace_back(bar);
    bar->hide();
  };
  for (QToolBar* bar : m_window.findChildren<QToolBar*>())
    hide(bar);
  hide(m_window.statusBar());
  if (!m_note)
    m_note = new FadingNote(*m_window.centralWidget());
  m_note->say(tr("F11 or Esc shows the panels again"));
}

} // namespace limn
