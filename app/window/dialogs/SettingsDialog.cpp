// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/dialogs/SettingsDialog.h"

#include "app/actions/Actions.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
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
  auto* rows = new QGridLayout(this); // boxes of one width
  rows->setColumnStretch(1, 1);
  const auto addChoice = [&](const QString& name, QActionGroup& group) {
    auto* label = new QLabel(name);
    QComboBox* box = choiceOf(group, name);
    label->setBuddy(box);
    rows->addWidget(label, rows->rowCount(), 0);
    rows->addWidget(box, rows->rowCount() - 1, 1);
  };
  const auto addWhole = [&](QWidget* widget) { rows->addWidget(widget, rows->rowCount(), 0, 1, 2); };
  addChoice(tr("Theme"), *actions.themes);
  addChoice(tr("Language"), *actions.languages);
  addChoice(tr("Draw with"), *actions.engines);
  for (QAction* action : {actions.refineAtRest, actions.patientInTitle})
    addWhole(switchOf(*action));
  auto* clear = new QPushButton(tr("Clear recent files"));
  clear->setAutoDefault(false);
  clear->setToolTip(tr("Empties the list of recent files, and with it where volumes lie and dialogs open."));
  connect(clear, &QPushButton::clicked, this, &SettingsDialog::clearRecentRequested);
  addWhole(clear);
  auto* buttons = new QDialogButtonBox;
  buttons->addButton(tr("Close"), QDialogButtonBox::RejectRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  addWhole(buttons);
}

QComboBox* SettingsDialog::choiceOf(QActionGroup& group, const QString& name) {
  auto* box = new QComboBox;
  box->setMinimumWidth(220); // all alike
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
