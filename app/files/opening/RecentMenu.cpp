// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/opening/RecentMenu.h"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>

#include <algorithm>

namespace limn {

RecentMenu::RecentMenu(QMenu& menu) : QObject(&menu), m_menu(menu) {
  menu.installEventFilter(this);
}

// Perhaps while it is open, by whoever takes entries out: the next one is chosen then.
void RecentMenu::setTexts(const QStringList& texts) {
  const qsizetype active = m_entries.indexOf(m_menu.activeAction());
  m_menu.clear();
  m_entries.clear();
  for (int number = 0; number < texts.size(); ++number)
    m_entries << m_menu.addAction(QString(texts[number]).replace(QLatin1Char('&'), QStringLiteral("&&")),
                                  this, [this, number] { emit chosen(number); });
  m_menu.setEnabled(!m_entries.isEmpty());
  m_menu.addSeparator();
  m_menu.addAction(tr("&Clear this list"), this, &RecentMenu::cleared);
  if (m_entries.isEmpty())
    m_menu.close();
  else if (active >= 0 && m_menu.isVisible())
    m_menu.setActiveAction(m_entries[std::min(active, m_entries.size() - 1)]);
}

bool RecentMenu::remove(QAction* entry) {
  const qsizetype number = m_entries.indexOf(entry);
  if (number >= 0)
    emit removed(static_cast<int>(number));
  return number >= 0;
}

bool RecentMenu::offerRemoval(QAction* entry, const QPoint& at) {
  const qsizetype number = m_entries.indexOf(entry);
  if (number < 0)
    return false;
  auto* offer = new QMenu(&m_menu);
  offer->setObjectName(QStringLiteral("removalOffer"));
  offer->setAttribute(Qt::WA_DeleteOnClose);
  offer->addAction(tr("&Remove from this list"), this,
                   [this, number] { emit removed(static_cast<int>(number)); });
  offer->popup(at);
  return true;
}

// A right click opens nothing: in other lists, too, it tells what can be done.
bool RecentMenu::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &m_menu)
    return QObject::eventFilter(watched, event);
  if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete)
    return remove(m_menu.activeAction());
  if (event->type() == QEvent::ContextMenu) {
    const auto& asked = *static_cast<QContextMenuEvent*>(event);
    QAction* entry = m_menu.activeAction();
    if (asked.reason() == QContextMenuEvent::Keyboard && entry)
      return offerRemoval(entry, m_menu.mapToGlobal(m_menu.actionGeometry(entry).center()));
    return true;
  }
  if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonRelease) {
    const auto& click = *static_cast<QMouseEvent*>(event);
    QAction* entry = m_menu.actionAt(click.position().toPoint());
    if (click.button() != Qt::RightButton || !m_entries.contains(entry))
      return false;
    return event->type() == QEvent::MouseButtonPress || offerRemoval(entry, click.globalPosition().toPoint());
  }
  return false;
}

} // namespace limn
