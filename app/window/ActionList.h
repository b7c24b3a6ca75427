// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QActionGroup>
#include <QKeySequence>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QToolButton>
#include <QVariant>

#include <functional>
#include <utility>
#include <vector>

class QMainWindow;
class QMenu;
class QToolBar;

namespace limn {

enum class Menu { none, file, edit, view, preset, help };

/// Where an entry stands in a menu of the menu bar: sections lie between lines, rows in order within one.
struct MenuPlace {
  Menu menu = Menu::none;
  int section = 0;
  int row = 0;
};

/// Where something stands in the tool bar, likewise. Sections from `atTheEnd` on are at its right end.
struct ToolPlace {
  static constexpr int none = 0;
  static constexpr int atTheEnd = 100;
  int section = none;
  int row = 0;
};

/// How an action looks, and where it is found.
struct ActionLook {
  QString text;
  MenuPlace place = {};
  QKeySequence shortcut = {};
  QString toolTip = {};
  QString icon = {};     ///< its name (widgets/Icons)
  QString iconText = {}; ///< what the tool bar calls it, where that is not its text
  ToolPlace tool = {};
  bool isCheckable = false;
  bool needsVolume = false; ///< out of use while none is open
};

/// Everything that can be chosen in menus, tool bar and settings. A feature registers in its constructor what
/// it offers and where it stands; `arrange` then builds menus and tool bar of what was registered. Object
/// names of actions are unique: `find` leads from one feature to another's.
class ActionList : public QObject {
  Q_OBJECT

public:
  /// Actions and the menu bar's menus are children of `window`.
  explicit ActionList(QMainWindow& window);

  QAction* add(const QString& name, const ActionLook& look);
  /// The same of an action that somebody else has made.
  QAction* add(QAction* action, const QString& name, const ActionLook& look);

  /// Choices of which one holds. Its actions are checkable and stand in the menus, unless `menu` has them in
  /// a menu of its own.
  QActionGroup* addGroup();
  QAction* addChoice(QActionGroup& group, const QString& name, const QVariant& data, ActionLook look);

  /// A menu within a menu, which whoever asks for it fills.
  QMenu* addMenu(const QString& title, const MenuPlace& place);

  /// A button of the tool bar that opens a menu. The action returned shows and hides it.
  QAction* addMenuButton(QToolButton& button, QMenu* menu, const ToolPlace& place);
  /// A button for that, with its text beside its icon.
  QToolButton* makeMenuButton(const QString& name, QToolButton::ToolButtonPopupMode mode);

  /// Has the button of an action of the tool bar open a menu of others beside it, which must have been
  /// registered once `arrange` is called. Of choices it shows the one that was made last.
  void addToolMenu(const QString& action, const QStringList& entries);

  /// Has the settings show a switch, a choice named `label`, or a button; they stand in the order of `row`.
  struct Setting {
    int row = 0;
    QString label = {};             ///< of a choice
    QActionGroup* choice = nullptr; ///< either this
    QAction* action = nullptr;      ///< or this: a switch where it is checkable, otherwise a button
    QString consequence = {};       ///< said below a choice once another was made; empty: nothing
  };
  void addSetting(const Setting& setting);
  const std::vector<Setting>& settings() const { return m_settings; }

  /// Keeps the icon of an action or a button in the colours of the window.
  template <class Target>
  void giveIcon(Target& target, const QString& icon) {
    giveIcon([this, &target, icon] { target.setIcon(iconNamed(icon)); });
  }

  /// The action of this object name, which must have been registered.
  QAction& find(const char* name) const;
  /// In the order in which they were registered.
  const QList<QAction*>& all() const { return m_all; }

  /// The menu of the menu bar.
  QMenu& menu(Menu menu) const { return *m_menus.at(static_cast<std::size_t>(menu)); }

  /// Builds menus and tool bar, once, after everything is registered.
  void arrange();

  /// Whether a volume is open; without one many actions mean nothing.
  void setVolumeOpen(bool isOpen) const;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  struct Entry {
    int menu; ///< of `Menu`, or the tool bar
    int section;
    int row;
    QAction* action;
  };
  void giveIcon(const std::function<void()>& refresh);
  QIcon iconNamed(const QString& icon) const;
  void place(QAction& action, const MenuPlace& place);
  void place(QAction& action, const ToolPlace& place);
  void fill(QWidget& bar, int menu);
  void openToolMenus();

  QMainWindow& m_window;
  QToolBar* m_bar;
  std::vector<QMenu*> m_menus; ///< in the order of `Menu`, the first null
  QList<QAction*> m_all;
  std::vector<Entry> m_entries;
  std::vector<std::pair<QString, QStringList>> m_toolMenus; ///< of actions of the tool bar
  QList<QAction*> m_needingVolume;
  std::vector<Setting> m_settings;
  std::vector<std::function<void()>> m_iconRefreshes;
};

/// Checks the action of a group that has this data, and no other.
void checkOnly(const QActionGroup& group, const QVariant& data);

} // namespace limn
