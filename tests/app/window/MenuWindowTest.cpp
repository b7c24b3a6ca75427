// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowHarness.h"
#include "app/panels/presets/PresetController.h"
#include "app/presets/PresetStore.h"
#include "widgets/theme/LookStyle.h"
#include "widgets/view/overlay/Overlay.h"

#include <QApplication>
#include <QMenu>
#include <QScreen>
#include <QTimer>

#include <string>

// Menus of the window, in its own style.

namespace limn {
namespace {

class MenuWindow : public test::WindowHarness {};

// The list of presets is filled as it opens, when its place was chosen for none; people have many of their
// own.
TEST_F(MenuWindow, theListOfPresetsLiesOnTheScreenWhereverTheLabelIs) {
  applyTheme(*qApp, ThemeChoice::light); // as in the program
  window->resize(1280, 800);
  ASSERT_TRUE(open(QStringLiteral("phantom:6")));
  ASSERT_TRUE(rest());
  const QRect screen = window->screen()->availableGeometry();
  auto& presets = *window->findChild<PresetController*>();
  for (const int own : {0, 40}) {
    for (int i = 0; i < own; ++i)
      PresetStore(UserFolders::below(folder.path()).presets)
          .save(
              presetOf(scene(), "My preset with a name that is as long as names are, " + std::to_string(i)));
    presets.refresh();
    const QPointF plate = labelsOf({view().order(), view().pictureState()}).front().plate.center();
    const QPoint inWindow = view().mapTo(window.get(), plate.toPoint());
    window->move(0, screen.bottom() - 60 - inWindow.y());
    ASSERT_TRUE(test::waitUntil([&] { return window->mapToGlobal(inWindow).y() > screen.bottom() - 100; }));
    QMenu* list = nullptr;
    QTimer::singleShot(0, window.get(), [&] {
      auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      ASSERT_NE(menu, nullptr);
      QTest::keyClick(menu, Qt::Key_Up);
      QTest::keyClick(menu, Qt::Key_Up); // the last but one entry
      list = menu->activeAction()->menu();
      ASSERT_NE(list, nullptr);
      QTest::keyClick(menu, Qt::Key_Right);
    });
    QTest::mouseClick(window->windowHandle(), Qt::LeftButton, {}, inWindow);
    ASSERT_TRUE(test::waitUntil([&] { return list && list->isVisible() && !list->actions().isEmpty(); }));
    EXPECT_TRUE(screen.contains(list->geometry())) << own;
    const QList<QAction*> entries = list->actions();
    EXPECT_EQ(entries.size(), 30 + own);
    for (QAction* entry : entries)
      EXPECT_EQ(list->actionGeometry(entry).left(), list->actionGeometry(entries.front()).left())
          << "in one column: " << entry->text().toStdString();
    QTest::keyClick(list, Qt::Key_End); // what has no room is scrolled to
    QTest::keyClick(list, Qt::Key_Up);
    const QAction* far = list->activeAction();
    ASSERT_NE(far, nullptr);
    EXPECT_TRUE(test::waitUntil(
        [&] { return list->rect().contains(list->actionGeometry(const_cast<QAction*>(far))); }));
    while (QWidget* open = QApplication::activePopupWidget())
      open->close();
  }
}

} // namespace
} // namespace limn
