// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/AppearanceDesk.h"

#include "widgets/Theme.h"

#include <QActionGroup>
#include <QApplication>
#include <QStatusBar>

namespace limn {

AppearanceDesk::AppearanceDesk(Settings& settings, const Actions& actions, QStatusBar& status,
                               QObject* parent)
    : QObject(parent) {
  checkOnly(*actions.themes, settings.theme());
  connect(actions.themes, &QActionGroup::triggered, this, [&settings](const QAction* chosen) {
    const QString theme = chosen->data().toString();
    settings.setTheme(theme);
    applyTheme(*static_cast<QApplication*>(QApplication::instance()), themeNamed(theme));
  });
  checkOnly(*actions.languages, settings.language());
  connect(actions.languages, &QActionGroup::triggered, this, [&settings, &status](const QAction* chosen) {
    settings.setLanguage(chosen->data().toString());
    status.showMessage(tr("The window speaks this language when it is opened the next time."), 8000);
  });
}

} // namespace limn
