// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/ActionList.h"

#include "app/WindowHarness.h"
#include "app/frame/dialogs/DialogController.h"
#include "scene/view/CompareLayout.h"

#include <QCheckBox>
#include <QComboBox>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>

#include <algorithm>
#include <set>

namespace limn {
namespace {

/// The actions that the parts of the window registered.
class ActionListTest : public test::WindowHarness {
protected:
  const ActionList& actions() const { return *window->findChild<ActionList*>(); }
};

TEST_F(ActionListTest, eachHasANameATextAndShortcutsOfItsOwn) {
  std::set<QString> names;
  std::set<QString> shortcuts;
  for (const QAction* action : actions().all()) {
    EXPECT_FALSE(action->objectName().isEmpty()) << action->text().toStdString();
    EXPECT_TRUE(names.insert(action->objectName()).second) << action->objectName().toStdString();
    EXPECT_FALSE(action->text().isEmpty()) << action->objectName().toStdString();
    for (const QKeySequence& shortcut : action->shortcuts())
      EXPECT_TRUE(shortcuts.insert(shortcut.toString()).second) << shortcut.toString().toStdString();
  }
  EXPECT_GE(names.size(), 60u);
}

TEST_F(ActionListTest, withoutAVolumeWhatNeedsOneIsDisabled) {
  for (const char* name : {"saveSession", "savePicture", "closeVolume", "cropBox", "view-anterior",
                           "savePreset", "layout-wipe", "model-right-classic"})
    EXPECT_FALSE(actions().find(name).isEnabled()) << name;
  for (const char* name : {"openFile", "findPreset", "settings"})
    EXPECT_TRUE(actions().find(name).isEnabled()) << name;
  ASSERT_TRUE(open(QStringLiteral("phantom:8")));
  EXPECT_TRUE(actions().find("saveSession").isEnabled());
}

TEST_F(ActionListTest, aChoiceOfAGroupIsCheckedAlone) {
  const QActionGroup& layouts = *actions().find("layout-wipe").actionGroup();
  checkOnly(layouts, static_cast<int>(CompareLayout::wipe));
  checkOnly(layouts, static_cast<int>(CompareLayout::single));
  EXPECT_EQ(layouts.checkedAction()->objectName(), QStringLiteral("layout-single"));
  checkOnly(layouts, {});
  EXPECT_EQ(layouts.checkedAction(), nullptr);
}

// What stays from run to run stands in the settings alone, and no second time in a menu.
TEST_F(ActionListTest, everyOneStandsInAMenuTheToolBarOrTheSettings) {
  QList<QAction*> choices, others;
  for (const ActionList::Setting& setting : actions().settings())
    if (setting.choice)
      choices << setting.choice->actions();
    else
      others << setting.action;
  for (QAction* action : actions().all())
    EXPECT_EQ(action->associatedObjects().isEmpty(), (choices + others).contains(action))
        << action->objectName().toStdString();
  const SettingsDialog settings(actions(), window.get());
  for (const QAction* action : others)
    EXPECT_TRUE(std::ranges::any_of(settings.findChildren<QAbstractButton*>(),
                                    [&](const QAbstractButton* box) {
                                      return box->text() == QString(action->text()).remove(QLatin1Char('&'));
                                    }))
        << action->objectName().toStdString();
  int offered = 0;
  for (const QComboBox* box : settings.findChildren<QComboBox*>())
    offered += box->count();
  EXPECT_EQ(offered, choices.size());
  EXPECT_GE(offered, 9);
}

TEST_F(ActionListTest, everyEntryOfTheViewMenuHasALetterOfItsOwn) {
  setLayout(CompareLayout::sideBySide);
  std::set<QChar> letters;
  for (const QAction* entry : actions().menu(Menu::view).actions()) {
    if (entry->isSeparator())
      continue;
    const qsizetype at = entry->text().indexOf(QLatin1Char('&'));
    ASSERT_GE(at, 0) << entry->text().toStdString();
    EXPECT_TRUE(letters.insert(entry->text()[at + 1].toLower()).second) << entry->text().toStdString();
  }
  EXPECT_GE(letters.size(), 20u);
}

// Sections lie between lines: none at the ends, and no two together.
TEST_F(ActionListTest, linesStandBetweenSections) {
  for (const Menu menu : {Menu::file, Menu::edit, Menu::view, Menu::preset, Menu::help}) {
    bool wasLine = true;
    for (const QAction* entry : actions().menu(menu).actions()) {
      EXPECT_FALSE(wasLine && entry->isSeparator()) << actions().menu(menu).title().toStdString();
      wasLine = entry->isSeparator();
    }
    EXPECT_FALSE(wasLine) << actions().menu(menu).title().toStdString();
  }
}

} // namespace
} // namespace limn
