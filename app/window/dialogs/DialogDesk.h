// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>

namespace limn {

class Actions;
class GuideWindow;
class SettingsDialog;
class StabilityDialog;

/// The dialogs that are about the program and not about what is shown: settings, guide, keys, stability
/// checks, about. None blocks the window.
class DialogDesk : public QObject {
  Q_OBJECT

public:
  /// `reports` is the folder for what the checks report.
  DialogDesk(const Actions& actions, QString reports, QWidget& window);

signals:
  /// What was opened before is to be forgotten.
  void clearRecentRequested();

private:
  void showSettings();
  void showStability();
  void showGuide();

  const Actions& m_actions;
  QString m_reports;
  QWidget& m_window;
  QPointer<SettingsDialog> m_settings;
  QPointer<StabilityDialog> m_stability;
  QPointer<GuideWindow> m_guide;
};

} // namespace limn
