// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QLocale>
#include <QString>

class QCoreApplication;

namespace limn {

/// A language that the window speaks.
struct Language {
  QString code; ///< ISO 639-1
  QString name; ///< in the language itself
};

/// English, which the sources are written in, and those that `app/translations` holds.
const QList<Language>& languagesSpoken();

/// How the window speaks: the words of one language, and how it writes numbers and dates.
struct Speech {
  QString code; ///< one of languagesSpoken()
  QLocale locale;
};

/// What `asked` comes to, "system" or the code of a language, on a system set to `system`. Numbers keep to
/// the system's country where its language is the one spoken, or where nobody asked for another.
Speech speechFor(const QString& asked, const QLocale& system);

/// To be called once Qt's application is there, which has set what the system says: our printf and that of
/// libraries would write commas into files.
void keepNumbersOfFiles();

/// Makes the window speak: words, those of Qt's own dialogs too, and numbers on the screen. The C library
/// keeps to the C locale, so that files are the same everywhere. Widgets that are there keep their words: to
/// be called before those are made that shall have the new ones.
void useLanguage(QCoreApplication& application, const QString& asked);

} // namespace limn
