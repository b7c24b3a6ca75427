// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/SettingsDialog.h"

#include "app/actions/Actions.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>

namespace limn {
namespace {

QString withoutMnemonic(QString text) {
  return text.remove(QLatin1Char('&'));
}

void showChoice(QComboBox& box, const QActionGroup& group) {
  const QSignalBlocker quiet(box);
  const QList<QAction*> actions = group.actions();
  box.clear();
  for (qsizetype i = 0; i < actions.size(); ++i) {
    box.addItem(withoutMnemonic(actions[i]->text()));
    box.setItemData(static_cast<int>(i), actions[i]->toolTip(), Qt::ToolTipRole);
    if (!actions[i]->isEnabled())
      static_cast<QStandardItemModel*>(box.model())->item(static_cast<int>(i))->setEnabled(false);
    if (actions[i]->isChecked())
      box.setCurrentIndex(static_cast<int>(i));
  }
}

} // namespace

SettingsDialog::SettingsDialog(const Actions& actions, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Settings"));
  auto* rows = new QFormLayout(this);
  rows->addRow(tr("Theme"), choiceOf(*actions.themes, tr("Theme")));
  rows->addRow(tr("Language"), choiceOf(*actions.languages, tr("Language")));
  rows->addRow(tr("Engine"), choiceOf(*actions.engines, tr("Engine")));
  for (QAction* action : {actions.refineAtRest, actions.patientInTitle})
    rows->addRow(switchOf(*action));
  auto* clear = new QPushButton(tr("Forget what was opened before"));
  clear->setAutoDefault(false);
  clear->setToolTip(tr("Empties the list of recent files, and with it where volumes lie and dialogs open."));
  connect(clear, &QPushButton::clicked, this, &SettingsDialog::clearRecentRequested);
  rows->addRow(clear);
  auto* buttons = new QDialogButtonBox;
  buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  rows->addRow(buttons);
}

QComboBox* SettingsDialog::choiceOf(QActionGroup& group, const QString& name) {
  auto* box = new QComboBox;
  box->setAccessibleName(name);
  box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  showChoice(*box, group);
  for (QAction* action : group.actions())
    connect(action, &QAction::changed, box, [box, &group] { showChoice(*box, group); });
  connect(box, &QComboBox::activated, this, [&group](int index) { group.actions()[index]->trigger(); });
  return box;
}

QCheckBox* SettingsDialog::switchOf(QAction& action) {
  auto* box = new QCheckBox(withoutMnemonic(action.text()));
  box->setToolTip(action.toolTip());
  box->setChecked(action.isChecked());
  connect(&action, &QAction::toggled, box, &QCheckBox::setChecked);
  connect(box, &QCheckBox::clicked, &action, &QAction::trigger);
  return box;
}

} // namespace limn
