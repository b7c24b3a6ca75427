// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

class QAction;
class QMainWindow;
class QMenu;

namespace limn {

class Actions;
class ModelMenus;

/// The menus whose entries change.
struct ChangingMenus {
  QMenu* file = nullptr; ///< holds the two below
  QMenu* recentSources = nullptr;
  QMenu* unsavedSessions = nullptr;
  ModelMenus* models = nullptr; ///< in the menu of views and in the tool bar
};

/// Fills a window's menu bar and makes its tool bar; `panels` show and hide its panels.
ChangingMenus makeMenus(QMainWindow& window, Actions& actions, const QList<QAction*>& panels);

} // namespace limn
