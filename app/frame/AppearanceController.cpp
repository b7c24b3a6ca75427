// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/frame/AppearanceController.h"

#include "app/language/Language.h"
#include "app/window/WindowContext.h"
#include "widgets/theme/LookStyle.h"

#include <QApplication>
#include <QStatusBar>

namespace limn {

AppearanceController::AppearanceController(WindowContext& context)
    : QObject(&context.window), m_context(context) {
  addThemes();
  addLanguages();
}

// The data of the actions are the words in the settings.
void AppearanceController::addThemes() {
  QActionGroup* themes = m_context.actions.addGroup();
  const auto add = [&](const char* word, const QString& text) {
    m_context.actions.addChoice(*themes, QStringLiteral("theme-") + QLatin1String(word), QLatin1String(word),
                                {.text = text});
  };
  add("system", tr("Follow the system"));
  add("light", tr("Light"));
  add("dark", tr("Dark"));
  add("contrast", tr("High contrast"));
  checkOnly(*themes, m_context.settings.theme());
  m_context.actions.addSetting({.row = 1, .label = tr("Theme"), .choice = themes});
  connect(themes, &QActionGroup::triggered, this, [this](const QAction* chosen) {
    const QString theme = chosen->data().toString();
    m_context.settings.setTheme(theme);
    applyTheme(*static_cast<QApplication*>(QApplication::instance()), themeNamed(theme));
  });
}

void AppearanceController::addLanguages() {
  QActionGroup* languages = m_context.actions.addGroup();
  const auto add = [&](const QString& code, const QString& text) {
    m_context.actions.addChoice(*languages, QStringLiteral("language-") + code, code,
                                {.text = text, .toolTip = tr("The window uses it from the next start.")});
  };
  add(QStringLiteral("system"), tr("Follow the system"));
  for (const Language& language : languagesSpoken())
    add(language.code, language.name);
  checkOnly(*languages, m_context.settings.language());
  m_context.actions.addSetting({.row = 2, .label = tr("Language"), .choice = languages});
  connect(languages, &QActionGroup::triggered, this, [this](const QAction* chosen) {
    m_context.settings.setLanguage(chosen->data().toString());
    m_context.window.statusBar()->showMessage(
        tr("The window speaks this language when it is opened the next time."), 8000);
  });
}

} // namespace limn
