// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QAction;
class QActionGroup;
class QCheckBox;
class QComboBox;
class QPushButton;

namespace limn {

class ActionList;

/// What stays from run to run, whatever is open: its only place. It shows and triggers the actions that were
/// registered as settings.
class SettingsDialog : public QDialog {
  Q_OBJECT

public:
  SettingsDialog(const ActionList& actions, QWidget* parent);

private:
  QComboBox* choiceOf(QActionGroup& group, const QString& name);
  QCheckBox* switchOf(QAction& action);
  QPushButton* buttonOf(QAction& action);
};

} // namespace limn
