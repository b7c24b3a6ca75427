// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QAction;
class QActionGroup;
class QCheckBox;
class QComboBox;

namespace limn {

class Actions;

/// What stays from run to run, whatever is open: its only place. It shows and triggers the window's actions.
class SettingsDialog : public QDialog {
  Q_OBJECT

public:
  SettingsDialog(const Actions& actions, QWidget* parent);

signals:
  /// What was opened before is to be forgotten.
  void clearRecentRequested();

private:
  QComboBox* choiceOf(QActionGroup& group, const QString& name);
  QCheckBox* switchOf(QAction& action);
};

} // namespace limn
