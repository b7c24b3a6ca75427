// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/asking/LookFiles.h"

#include "io/looks/Look.h"
#include "io/scenefile/SceneFile.h"
#include "io/scenefile/SessionFile.h"
#include "scene/basics/Error.h"
#include "widgets/Translated.h"

#include <QFileInfo>
#include <QObject>

#include <algorithm>

namespace limn {
namespace {

constexpr qint64 largestFile = 16 << 20; // bytes; readTextFile takes no more

QString patterns(const LookFormat& format) {
  QStringList endings;
  for (const std::string& ending : format.endings)
    endings << QStringLiteral("*%1").arg(QString::fromStdString(ending));
  return endings.join(QLatin1Char(' '));
}

} // namespace

bool holdsLooks(const QString& path) {
  const QFileInfo file(path);
  if (!hasLookEnding(file.fileName().toStdString()) || !file.isFile() || file.size() > largestFile)
    return false;
  try {
    const std::string text = readTextFile(path.toStdString());
    const LookFormat* format = lookFormatOf(text);
    return format && !format->isScene && !looksLikeSession(text) && !looksLikeScene(text);
  } catch (const Error&) {
    return false;
  }
}

QStringList readLookFilters() {
  QStringList all;
  for (const LookFormat& format : lookFormats())
    all << patterns(format);
  all.removeDuplicates();
  return {QObject::tr("Looks of Limn and other programs (%1)").arg(all.join(QLatin1Char(' '))),
          QObject::tr("All files (*)")};
}

QStringList writtenLookFilters(const QString& first) {
  QStringList filters;
  for (const LookFormat& format : lookFormats())
    if (format.write && !format.isScene) { // those are saved with a series
      const QString filter = QStringLiteral("%1 (%2)").arg(translated(format.name), patterns(format));
      const bool isFirst = std::ranges::find(format.endings, first.toStdString()) != format.endings.end();
      isFirst ? filters.prepend(filter) : filters.append(filter);
    }
  return filters;
}

} // namespace limn
