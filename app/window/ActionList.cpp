// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/ActionList.h"

#include "widgets/controls/Popups.h"
#include "widgets/theme/Icons.h"

#include <QEvent>
#include <QMainWindow>
#include <QMenu>
#include <QMenuBar>
#include <QToolBar>
#include <QWidgetAction>

#include <algorithm>
#include <cassert>
#include <tuple>

namespace limn {
namespace {

constexpr int toolBar = -1; // among the menus

} // namespace

ActionList::ActionList(QMainWindow& window)
    : QObject(&window), m_window(window), m_bar(window.addToolBar(tr("Tools"))) {
  window.installEventFilter(this);
  m_menus = {nullptr};
  for (const QString& title : {tr("&File"), tr("&Edit"), tr("&View"), tr("&Preset"), tr("&Help")})
    m_menus.push_back(window.menuBar()->addMenu(title));
  menu(Menu::file).setToolTipsVisible(true);
  m_bar->setObjectName(QStringLiteral("toolBar"));
  m_bar->setMovable(false);
  m_bar->setIconSize({20, 20});
  // Qt's own button for what has no room.
  if (auto* more = m_bar->findChild<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"))) {
    more->setAccessibleName(tr("More tools"));
    more->setToolTip(tr("Tools that find no room here."));
    giveIcon(*more, QStringLiteral("more-tools"));
  }
}

QAction* ActionList::add(const QString& name, const ActionLook& look) {
  return add(new QAction(look.text, &m_window), name, look);
}

QAction* ActionList::add(QAction* action, const QString& name, const ActionLook& look) {
  action->setObjectName(name);
  if (!look.shortcut.isEmpty())
    action->setShortcut(look.shortcut);
  if (!look.toolTip.isEmpty())
    action->setToolTip(look.toolTip);
  if (!look.icon.isEmpty())
    giveIcon(*action, look.icon);
  if (!look.iconText.isEmpty())
    action->setIconText(look.iconText);
  action->setCheckable(look.isCheckable);
  if (look.needsVolume)
    m_needingVolume << action;
  place(*action, look.place);
  place(*action, look.tool);
  m_all << action;
  return action;
}

QActionGroup* ActionList::addGroup() {
  return new QActionGroup(&m_window);
}

QAction* ActionList::addChoice(QActionGroup& group, const QString& name, const QVariant& data,
                               ActionLook look) {
  look.isCheckable = true;
  QAction* action = add(name, look);
  action->setData(data);
  return group.addAction(action);
}

QMenu* ActionList::addMenu(const QString& title, const MenuPlace& where) {
  auto* inner = new QMenu(title, &menu(where.menu));
  place(*inner->menuAction(), where);
  return inner;
}

QToolButton* ActionList::makeMenuButton(const QString& name, QToolButton::ToolButtonPopupMode mode) {
  auto* button = new QToolButton(m_bar);
  button->setObjectName(name);
  button->setPopupMode(mode);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  return button;
}

QAction* ActionList::addMenuButton(QToolButton& button, QMenu* menu, const ToolPlace& where) {
  button.setMenu(menu);
  looksIdleAfterMenu(button);
  auto* action = new QWidgetAction(m_bar);
  action->setDefaultWidget(&button);
  place(*action, where);
  return action;
}

void ActionList::addToolMenu(const QString& action, const QStringList& entries) {
  m_toolMenus.emplace_back(action, entries);
}

void ActionList::addSetting(const Setting& setting) {
  m_settings.push_back(setting);
  std::ranges::stable_sort(m_settings, {}, &Setting::row);
}

QAction& ActionList::find(const char* name) const {
  const auto found = std::ranges::find(m_all, QLatin1String(name), &QAction::objectName);
  assert(found != m_all.end());
  return **found;
}

void ActionList::place(QAction& action, const MenuPlace& place) {
  if (place.menu != Menu::none)
    m_entries.push_back({static_cast<int>(place.menu), place.section, place.row, &action});
}

void ActionList::place(QAction& action, const ToolPlace& place) {
  if (place.section != ToolPlace::none)
    m_entries.push_back({toolBar, place.section, place.row, &action});
}

void ActionList::arrange() {
  std::ranges::stable_sort(
      m_entries, {}, [](const Entry& entry) { return std::tuple(entry.menu, entry.section, entry.row); });
  for (int number = 1; number < static_cast<int>(m_menus.size()); ++number)
    fill(*m_menus[static_cast<std::size_t>(number)], number);
  fill(*m_bar, toolBar);
  openToolMenus();
}

void ActionList::openToolMenus() {
  for (const auto& [name, entries] : m_toolMenus) {
    auto* button = qobject_cast<QToolButton*>(m_bar->widgetForAction(&find(name.toLatin1().constData())));
    assert(button);
    auto* menu = new QMenu(button);
    menu->setToolTipsVisible(true);
    for (const QString& entry : entries) {
      QAction* one = &find(entry.toLatin1().constData());
      menu->addAction(one);
      if (one->isCheckable())
        connect(one, &QAction::toggled, button, [button, one](bool isOn) {
          if (isOn)
            button->setDefaultAction(one);
        });
    }
    button->setMenu(menu);
    button->setPopupMode(QToolButton::MenuButtonPopup);
    looksIdleAfterMenu(*button);
  }
}

void ActionList::fill(QWidget& bar, int menu) {
  const auto addLine = [&bar] {
    auto* line = new QAction(&bar);
    line->setSeparator(true);
    bar.addAction(line);
  };
  int section = 0;
  for (const Entry& entry : m_entries) {
    if (entry.menu != menu)
      continue;
    const bool isAtTheEnd = menu == toolBar && entry.section >= ToolPlace::atTheEnd;
    if (isAtTheEnd && section < ToolPlace::atTheEnd) {
      auto* stretch = new QWidget(m_bar);
      stretch->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
      m_bar->addWidget(stretch);
    } else if (section != 0 && section != entry.section) {
      addLine();
    }
    section = entry.section;
    bar.addAction(entry.action);
  }
}

void ActionList::setVolumeOpen(bool isOpen) const {
  for (QAction* action : m_needingVolume)
    action->setEnabled(isOpen);
}

QIcon ActionList::iconNamed(const QString& icon) const {
  return themedIcon(icon, m_window.palette());
}

void ActionList::giveIcon(const std::function<void()>& refresh) {
  m_iconRefreshes.push_back(refresh);
  refresh();
}

bool ActionList::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::PaletteChange)
    for (const auto& refresh : m_iconRefreshes)
      refresh();
  return QObject::eventFilter(watched, event);
}

void checkOnly(const QActionGroup& group, const QVariant& data) {
  for (QAction* action : group.actions())
    action->setChecked(action->data() == data);
}

} // namespace limn
