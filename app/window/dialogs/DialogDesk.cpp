// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/DialogDesk.h"

#include "app/actions/Actions.h"
#include "app/actions/HelpBoxes.h"
#include "app/help/GuidePlaces.h"
#include "app/help/GuideWindow.h"
#include "app/window/dialogs/SettingsDialog.h"
#include "app/window/dialogs/StabilityDialog.h"

#include <QCoreApplication>

namespace limn {

DialogDesk::DialogDesk(const Actions& actions, QString reports, QWidget& window)
    : QObject(&window), m_actions(actions), m_reports(std::move(reports)), m_window(window) {
  connect(actions.shortcuts, &QAction::triggered, this, [this] { showShortcuts(m_actions, &m_window); });
  connect(actions.about, &QAction::triggered, this, [this] { showAbout(&m_window); });
  connect(actions.settings, &QAction::triggered, this, &DialogDesk::showSettings);
  connect(actions.guide, &QAction::triggered, this, &DialogDesk::showGuide);
  connect(actions.stability, &QAction::triggered, this, &DialogDesk::showStability);
}

void DialogDesk::showSettings() {
  if (!m_settings) {
    m_settings = new SettingsDialog(m_actions, &m_window);
    m_settings->setAttribute(Qt::WA_DeleteOnClose);
    connect(m_settings, &SettingsDialog::clearRecentRequested, this, &DialogDesk::clearRecentRequested);
  }
  m_settings->show();
  m_settings->raise();
}

// It stays while it is hidden: checks go on, and what they found is there when it is opened again.
void DialogDesk::showStability() {
  if (!m_stability)
    m_stability = new StabilityDialog(QCoreApplication::applicationFilePath(), m_reports, &m_window);
  m_stability->show();
  m_stability->raise();
}

// It stays while it is hidden, where the reader left it.
void DialogDesk::showGuide() {
  const QString place = guidePlaceOf(m_window.focusWidget());
  if (!m_guide)
    m_guide = new GuideWindow(&m_window);
  m_guide->show();
  m_guide->raise();
  m_guide->activateWindow();
  m_guide->showPlace(place);
}

} // namespace limn
