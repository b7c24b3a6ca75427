// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/dialogs/SettingsDialog.h"

#include "app/window/ActionList.h"

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

SettingsDialog::SettingsDialog(const ActionList& actions, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Settings"));
  auto* rows = new QGridLayout(this); // boxes of one width
  rows->setColumnStretch(1, 1);
  const auto addWhole = [&](QWidget* widget) { rows->addWidget(widget, rows->rowCount(), 0, 1, 2); };
  for (const ActionList::Setting& setting : actions.settings()) {
    if (setting.choice) {
      auto* label = new QLabel(setting.label);
      QComboBox* box = choiceOf(*setting.choice, setting.label);
      label->setBuddy(box);
      rows->addWidget(label, rows->rowCount(), 0);
      rows->addWidget(box, rows->rowCount() - 1, 1);
    } else if (setting.action->isCheckable()) {
      addWhole(switchOf(*setting.action));
    } else {
      addWhole(buttonOf(*setting.action));
    }
  }
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

QPushButton* SettingsDialog::buttonOf(QAction& action) {
  auto* button = new QPushButton(action.text());
  button->setAutoDefault(false);
  button->setToolTip(action.toolTip());
  connect(button, &QPushButton::clicked, &action, &QAction::trigger);
  return button;
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
