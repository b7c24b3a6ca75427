// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/PrivateNames.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>

namespace limn {
namespace {

// Shorter words stand in too many other words.
constexpr int shortestPart = 4;

QStringList wordsOf(const QString& text) {
  static const QRegularExpression between(QStringLiteral("[^\\p{L}\\p{N}]+"));
  return text.toCaseFolded().split(between, Qt::SkipEmptyParts);
}

// Whether a text contains one of the words, short ones as a whole word.
bool holdsOneOf(const QString& text, const QStringList& sought) {
  const QStringList words = wordsOf(text);
  const QString all = words.join(QString());
  return std::ranges::any_of(sought, [&](const QString& word) {
    return words.contains(word) || (word.size() >= shortestPart && all.contains(word));
  });
}

// A DICOM UID, or a date in digits: the day before or behind the year, with or without separators.
bool holdsDateOrUid(const QString& text) {
  static const QRegularExpression uid(QStringLiteral("\\d+(\\.\\d+){3,}"));
  static const QRegularExpression date(
      QStringLiteral("(?<!\\d)((19|20)\\d\\d[-_. ]?(0[1-9]|1[0-2])[-_. ]?(0[1-9]|[12]\\d|3[01])"
                     "|(0[1-9]|[12]\\d|3[01])[-_. ]?(0[1-9]|1[0-2])[-_. ]?(19|20)\\d\\d)(?!\\d)"));
  return uid.match(text).hasMatch() || date.match(text).hasMatch();
}

} // namespace

bool mayNameThePatient(const QString& name, const PatientLabel& patient) {
  QStringList sought = wordsOf(QString::fromStdString(patient.name));
  if (const QString id = wordsOf(QString::fromStdString(patient.id)).join(QString()); !id.isEmpty())
    sought << id;
  return holdsOneOf(name, sought) || holdsDateOrUid(name);
}

bool pathMayNameThePatient(const QString& path, const PatientLabel& patient) {
  const QStringList parts = path.split(QLatin1Char('/'), Qt::SkipEmptyParts);
  return std::ranges::any_of(parts, [&](const QString& part) { return mayNameThePatient(part, patient); });
}

QString plainDescription(const Volume& volume) {
  const glm::ivec3& dims = volume.grid().dims;
  const QString size = QStringLiteral("%1×%2×%3").arg(dims.x).arg(dims.y).arg(dims.z);
  const QString modality = QString::fromStdString(volume.info().modality);
  return modality.isEmpty() ? size : modality + QLatin1Char(' ') + size;
}

QString plainFileName(const Volume& volume) {
  return plainDescription(volume)
      .toLower()
      .replace(QLatin1Char(' '), QLatin1Char('-'))
      .replace(QChar(0x00D7), QLatin1Char('x'));
}

QString shareableName(const QString& path, const Volume& volume) {
  const QString name = QFileInfo(path).fileName();
  return mayNameThePatient(name, volume.info().patient) ? plainFileName(volume) : name;
}

} // namespace limn
