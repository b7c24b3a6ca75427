// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/dialogs/DialogController.h"

#include "app/frame/dialogs/HelpBoxes.h"
#include "app/frame/dialogs/SettingsDialog.h"
#include "app/frame/dialogs/StabilityDialog.h"
#include "app/guide/GuideWindow.h"
#include "app/window/WindowContext.h"
#include "widgets/view/CompareView.h"

#include <QCoreApplication>

namespace limn {

DialogController::DialogController(WindowContext& context) : QObject(&context.window), m_context(context) {
  QAction* settings =
      context.actions.add(QStringLiteral("settings"),
                          {.text = tr("&Settings…"), .place = {Menu::edit, 3, 1}, .shortcut = tr("Ctrl+,")});
  settings->setMenuRole(QAction::PreferencesRole);
  connect(settings, &QAction::triggered, this, &DialogController::showSettings);
  addHelp();
}

void DialogController::addHelp() {
  ActionList& actions = m_context.actions;
  const QAction* guide =
      actions.add(QStringLiteral("guide"),
                  {.text = tr("&Guide"),
                   .place = {Menu::help, 1, 1},
                   .shortcut = QKeySequence::HelpContents,
                   .toolTip = tr("Opens the guide at what it says of the panel with the keyboard.")});
  QAction* shortcuts = actions.add(
      QStringLiteral("shortcuts"),
      {.text = QStringLiteral("%1\t%2").arg(tr("Mouse and &keys"), tr("?")), .place = {Menu::help, 1, 3}});
  const QAction* stability = actions.add(
      QStringLiteral("stability"),
      {.text = tr("&Stability checks…"),
       .place = {Menu::help, 1, 4},
       .toolTip = tr("Checks what this computer's driver draws where renderers are known to fail.")});
  const QAction* about =
      actions.add(QStringLiteral("about"), {.text = tr("&About Limn"), .place = {Menu::help, 1, 5}});
  connect(guide, &QAction::triggered, this, &DialogController::showGuide);
  connect(shortcuts, &QAction::triggered, this,
          [this] { showShortcuts(m_context.actions, &m_context.window); });
  connect(&m_context.view, &CompareView::shortcutListRequested, shortcuts, &QAction::trigger);
  connect(stability, &QAction::triggered, this, &DialogController::showStability);
  connect(about, &QAction::triggered, this, [this] { showAbout(&m_context.window); });
}

void DialogController::showSettings() {
  if (!m_settings) {
    m_settings = new SettingsDialog(m_context.actions, &m_context.window);
    m_settings->setAttribute(Qt::WA_DeleteOnClose);
  }
  m_settings->show();
  m_settings->raise();
}

// It stays while it is hidden: checks go on, and what they found is there when it is opened again.
void DialogController::showStability() {
  if (!m_stability)
    m_stability =
        new StabilityDialog(QCoreApplication::applicationFilePath(),
                            QString::fromStdString(m_context.folders.reports.string()), &m_context.window);
  m_stability->show();
  m_stability->raise();
}

// It stays while it is hidden, where the reader left it.
void DialogController::showGuide() {
  const QString place = guidePlaceOf(m_context.window.focusWidget());
  if (!m_guide)
    m_guide = new GuideWindow(&m_context.window);
  m_guide->show();
  m_guide->raise();
  m_guide->activateWindow();
  m_guide->showPlace(place);
}

} // namespace limn
