// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/Actions.h"

#include "app/actions/Menus.h"
#include "scene/view/CompareLayout.h"

#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QUndoStack>

#include <gtest/gtest.h>

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
                                actions.cropBox, actions.views->actions().front(), actions.savePreset})
    EXPECT_FALSE(action->isEnabled()) << action->objectName().toStdString();
  for (const QAction* action : {actions.openFile, actions.findPreset, actions.layouts->actions().front()})
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

TEST_F(ActionsTest, everyOneStandsInAMenuOrInTheToolBar) {
  makeMenus(window, actions, {});
  for (const QAction* action : all())
    EXPECT_FALSE(action->associatedObjects().isEmpty()) << action->objectName().toStdString();
}

} // namespace
} // namespace limn
