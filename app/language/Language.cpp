// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/language/Language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QTranslator>

#include <clocale>
#include <cstdio>
#include <memory>

namespace limn {
namespace {

const QString english = QStringLiteral("en");

bool isSpoken(const QString& code) {
  for (const Language& language : languagesSpoken())
    if (language.code == code)
      return true;
  return false;
}

QString codeOf(const QLocale& locale) {
  return locale.name().section(QLatin1Char('_'), 0, 0);
}

const QString wordsName = QStringLiteral("limnWords");

bool install(QCoreApplication& application, const QString& file, const QString& folder) {
  auto words = std::make_unique<QTranslator>();
  if (!words->load(file, folder) || !QCoreApplication::installTranslator(words.get()))
    return false;
  words->setObjectName(wordsName);
  words.release()->setParent(&application);
  return true;
}

void removeWords(QCoreApplication& application) {
  for (QTranslator* words : application.findChildren<QTranslator*>(wordsName, Qt::FindDirectChildrenOnly))
    delete words; // which takes it out of use
}

} // namespace

const QList<Language>& languagesSpoken() {
  static const QList<Language> all{{english, QStringLiteral("English")},
                                   {QStringLiteral("de"), QStringLiteral("Deutsch")}};
  return all;
}

Speech speechFor(const QString& asked, const QLocale& system) {
  const bool isChosen = isSpoken(asked);
  const QString code = isChosen ? asked : codeOf(system);
  if (isChosen && codeOf(system) != code)
    return {code, QLocale(code)};
  return {isSpoken(code) ? code : english, system};
}

void keepNumbersOfFiles() {
  std::setlocale(LC_NUMERIC, "C");
}

void useLanguage(QCoreApplication& application, const QString& asked) {
  keepNumbersOfFiles();
  const Speech speech = speechFor(asked, QLocale::system());
  QLocale::setDefault(speech.locale);
  removeWords(application);
  if (speech.code == english)
    return;
  const QString embedded = QStringLiteral(":/translations");
  // Qt's own words come first, so that ours go before them.
  if (!install(application, QStringLiteral("qtbase_") + speech.code, embedded) &&
      !install(application, QStringLiteral("qtbase_") + speech.code,
               QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
    std::fprintf(stderr,
                 "limn: Qt's own dialogs stay English; the package qt6-translations-l10n has their words.\n");
  install(application, QStringLiteral("limn_") + speech.code, embedded);
}

} // namespace limn
