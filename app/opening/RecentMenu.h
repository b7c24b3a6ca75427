// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QMenu;

namespace limn {

class Settings;

/// The menu of what was opened before, in every window of this user.
class RecentMenu : public QObject {
  Q_OBJECT

public:
  RecentMenu(Settings& settings, QMenu& menu);

  void add(const QString& path, const QString& label);
  void remove(const QString& path);

signals:
  void chosen(const QString& path);

private:
  void refresh();

  Settings& m_settings;
  QMenu& m_menu;
};

} // namespace limn
