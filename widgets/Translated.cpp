// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/Translated.h"

#include "scene/basics/Error.h"
#include "widgets/ValueText.h"

#include <QCoreApplication>
#include <QObject>

namespace limn {
namespace {

// In functions that return a type of another namespace lupdate takes our class by its bare name.
QString patternInLanguage(const std::string& english) {
  const QString translation = QCoreApplication::translate("limn::Message", english.c_str());
  return translation != QString::fromStdString(english)
             ? translation
             : QCoreApplication::translate("Message", english.c_str());
}

} // namespace

QString translated(const Message& message) {
  if (message.kind() == Message::Kind::verbatim)
    return QString::fromStdString(message.text());
  if (message.kind() == Message::Kind::fixed)
    return fixedNumber(message.number(), message.digits());
  if (message.kind() == Message::Kind::rounded)
    return digitsNumber(message.number(), message.digits());
  const QString pattern = patternInLanguage(message.text());
  QString filled;
  // In one go: what stands in a place may hold a percent sign of its own.
  for (qsizetype i = 0; i < pattern.size(); ++i) {
    const int place =
        pattern[i] == QLatin1Char('%') && i + 1 < pattern.size() ? pattern[i + 1].digitValue() : 0;
    if (place < 1 || place > static_cast<int>(message.arguments().size())) {
      filled += pattern[i];
      continue;
    }
    filled += translated(message.arguments()[static_cast<std::size_t>(place - 1)]);
    ++i;
  }
  return filled;
}

QString translated(const std::exception& failure) {
  const auto* error = dynamic_cast<const Error*>(&failure);
  return error ? translated(error->sentence()) : QString::fromLocal8Bit(failure.what());
}

QString inSentence(const QString& label) {
  //: Not shown. Translate it as "capital" where nouns within a sentence have one.
  if (QObject::tr("small", "labels within a sentence") == QLatin1String("capital"))
    return label;
  QStringList words = label.split(QChar(0x2013)); // "Right–Left"
  for (QString& word : words)
    if (const bool isAcronym = word.size() > 1 && word.at(1).isUpper(); !isAcronym)
      word = word.left(1).toLower() + word.mid(1);
  return words.join(QChar(0x2013));
}

} // namespace limn
