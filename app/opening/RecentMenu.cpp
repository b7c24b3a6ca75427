// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/opening/RecentMenu.h"

#include "app/Settings.h"

#include <QDateTime>
#include <QLocale>
#include <QMenu>

#include <algorithm>

namespace limn {

RecentMenu::RecentMenu(Settings& settings, QMenu& menu) : m_settings(settings), m_menu(menu) {
  connect(&menu, &QMenu::aboutToShow, this, &RecentMenu::refresh);
  refresh();
}

void RecentMenu::add(const QString& path, const QString& label) {
  m_settings.addRecentSource(path, label);
  refresh();
}

void RecentMenu::remove(const QString& path) {
  m_settings.removeRecentSource(path);
  refresh();
}

void RecentMenu::refresh() {
  m_menu.clear();
  const QList<RecentSource> recent = m_settings.recentSources();
  for (const RecentSource& source : recent) {
    const bool isAlone = std::count_if(recent.begin(), recent.end(), [&](const RecentSource& other) {
                           return other.label == source.label;
                         }) == 1;
    const QDateTime opened = QDateTime::fromString(source.opened, Qt::ISODateWithMs).toLocalTime();
    QString text =
        isAlone ? source.label
                : tr("%1, opened %2").arg(source.label, QLocale().toString(opened, QLocale::ShortFormat));
    m_menu.addAction(text.replace(QLatin1Char('&'), QStringLiteral("&&")), this,
                     [this, path = source.path] { emit chosen(path); });
  }
  m_menu.setEnabled(!m_menu.isEmpty());
  m_menu.addSeparator();
  m_menu.addAction(tr("&Clear this list"), this, [this] {
    m_settings.clearRecentSources();
    m_menu.setEnabled(false);
  });
}

} // namespace limn
