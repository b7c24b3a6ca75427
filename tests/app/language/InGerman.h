// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/language/Language.h"

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

namespace limn::test {

/// While it lives the program speaks German.
class InGerman {
public:
  InGerman() { useLanguage(*QCoreApplication::instance(), QStringLiteral("de")); }
  ~InGerman() {
    for (QTranslator* words : QCoreApplication::instance()->findChildren<QTranslator*>()) {
      QCoreApplication::removeTranslator(words);
      delete words;
    }
    QLocale::setDefault(QLocale::c());
  }
  InGerman(const InGerman&) = delete;
  InGerman& operator=(const InGerman&) = delete;
};

} // namespace limn::test
