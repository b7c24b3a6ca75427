// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/Actions.h"

#include "app/actions/Menus.h"
#include "app/actions/ModelMenus.h"
#include "app/window/dialogs/SettingsDialog.h"
#include "scene/view/CompareLayout.h"

#include <QCheckBox>
#include <QComboBox>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QUndoStack>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

// The actions by themselves: no picture and no document behind them.

namespace limn {
namespace {

class ActionsTest : public testing::Test {
protected:
  // The actions and nothing else; separators and menus have names of Qt's.
  QList<QAction*> all() const { return window.findChildren<QAction*>(Qt::FindDirectChildrenOnly); }

  QUndoStack history;
  QMainWindow window;
  Actions actions{window, history};
};

TEST_F(ActionsTest, eachHasANameATextAndShortcutsOfItsOwn) {
  std::set<QString> names;
  std::set<QString> shortcuts;
  for (const QAction* action : all()) {
    EXPECT_FALSE(action->objectName().isEmpty()) << action->text().toStdString();
    EXPECT_TRUE(names.insert(action->objectName()).second) << action->objectName().toStdString();
    EXPECT_FALSE(action->text().isEmpty()) << action->objectName().toStdString();
    for (const QKeySequence& shortcut : action->shortcuts())
      EXPECT_TRUE(shortcuts.insert(shortcut.toString()).second) << shortcut.toString().toStdString();
  }
  EXPECT_GE(names.size(), 30u);
}

TEST_F(ActionsTest, withoutAVolumeWhatNeedsOneIsDisabled) {
  actions.setVolumeOpen(false);
  for (const QAction* action : {actions.saveSession, actions.savePicture, actions.closeVolume,
                                actions.cropBox, actions.views->actions().front(), actions.savePreset,
                                actions.layouts->actions().front(), actions.models[1]->actions().front()})
    EXPECT_FALSE(action->isEnabled()) << action->objectName().toStdString();
  for (const QAction* action : {actions.openFile, actions.findPreset, actions.settings})
    EXPECT_TRUE(action->isEnabled()) << action->objectName().toStdString();
  actions.setVolumeOpen(true);
  EXPECT_TRUE(actions.saveSession->isEnabled());
}

TEST_F(ActionsTest, aChoiceOfAGroupIsCheckedAlone) {
  checkOnly(*actions.layouts, static_cast<int>(CompareLayout::wipe));
  checkOnly(*actions.layouts, static_cast<int>(CompareLayout::single));
  EXPECT_EQ(actions.layouts->checkedAction()->objectName(), QStringLiteral("layout-single"));
  checkOnly(*actions.models[0], {});
  EXPECT_EQ(actions.models[0]->checkedAction(), nullptr);
}

// What stays from run to run stands in the settings alone, and no second time in a menu.
TEST_F(ActionsTest, everyOneStandsInAMenuTheToolBarOrTheSettings) {
  makeMenus(window, actions, {});
  const QList<QAction*> chosen =
      actions.themes->actions() + actions.languages->actions() + actions.engines->actions();
  const QList<QAction*> kept = chosen + QList<QAction*>{actions.refineAtRest, actions.patientInTitle};
  for (QAction* action : all())
    EXPECT_EQ(action->associatedObjects().isEmpty(), kept.contains(action))
        << action->objectName().toStdString();
  const SettingsDialog settings(actions, &window);
  for (QAction* action : {actions.refineAtRest, actions.patientInTitle})
    EXPECT_TRUE(std::ranges::any_of(settings.findChildren<QCheckBox*>(), [&](const QCheckBox* box) {
      return box->text() == QString(action->text()).remove(QLatin1Char('&'));
    })) << action->objectName().toStdString();
  int choices = 0;
  for (const QComboBox* box : settings.findChildren<QComboBox*>())
    choices += box->count();
  EXPECT_EQ(choices, chosen.size());
}

TEST_F(ActionsTest, everyEntryOfTheViewMenuHasALetterOfItsOwn) {
  const ChangingMenus menus = makeMenus(window, actions, {});
  menus.models->show({ShadingModel::classic, ShadingModel::enhanced});
  std::set<QChar> letters;
  for (const QAction* entry : window.menuBar()->actions()[2]->menu()->actions()) {
    if (entry->isSeparator())
      continue;
    const qsizetype at = entry->text().indexOf(QLatin1Char('&'));
    ASSERT_GE(at, 0) << entry->text().toStdString();
    EXPECT_TRUE(letters.insert(entry->text()[at + 1].toLower()).second) << entry->text().toStdString();
  }
  EXPECT_GE(letters.size(), 10u);
}

} // namespace
} // namespace limn
