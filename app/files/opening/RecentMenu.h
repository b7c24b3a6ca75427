// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>
#include <QStringList>

class QAction;
class QMenu;
class QPoint;

namespace limn {

/// Fills a menu with what was opened before. Del, or what a right click offers, takes one out of the list;
/// the menu stays open.
class RecentMenu : public QObject {
  Q_OBJECT

public:
  explicit RecentMenu(QMenu& menu);

  /// Latest first; a menu of none cannot be opened.
  void setTexts(const QStringList& texts);

signals:
  void chosen(int number); ///< of setTexts, from 0 on
  void removed(int number);
  void cleared(); ///< all

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  bool remove(QAction* entry);
  bool offerRemoval(QAction* entry, const QPoint& at);

  QMenu& m_menu;
  QList<QAction*> m_entries;
};

} // namespace limn
