// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guide/Guide.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cassert>

// Beyond the namespace, as Qt's macro wants it: a linker drops a static library's resources unless asked.
static void loadGuide() {
  Q_INIT_RESOURCE(guide);
}

namespace limn {
namespace {

struct Place {
  const char* id;
  const char* path;
};

constexpr Place places[] = {
    {"start", "start.md"},
    {"gestures", "gestures.md"},
    {"panels", "panels.md"},
    {"presets", "presets/README.md"},
    {"publish", "publish.md"},
    {"exactness", "exactness.md"},
    {"accuracy", "accuracy/README.md"},
    {"commands", "commands.md"},
    {"many", "many/README.md"},
    {"paper", "paper.md"},
    {"limits", "limits.md"},
    {"privacy", "privacy.md"},
};

// What a reader takes in at once: a paragraph, a line of a table, a block of code.
QStringList piecesOf(const QString& markdown) {
  QStringList pieces;
  bool isCode = false;
  bool goesOn = false;
  for (const QString& line : markdown.split(QLatin1Char('\n'))) {
    const bool isFence = line.startsWith(QLatin1String("```"));
    const bool isAlone = !isCode && (line.startsWith(QLatin1Char('|')) || line.startsWith(QLatin1Char('#')) ||
                                     line.startsWith(QLatin1String("- ")));
    if (goesOn && !isAlone && (isCode || !line.isEmpty()))
      pieces.back() += QLatin1Char('\n') + line;
    else if (!line.isEmpty())
      pieces << line;
    isCode ^= isFence;
    goesOn = isCode || (!line.isEmpty() && !line.startsWith(QLatin1Char('#')));
  }
  return pieces;
}

// Links as words: a terminal follows none, and what is no chapter lies in the sources alone.
QString withoutLinks(const QString& piece, const GuideChapter& chapter,
                     const std::vector<GuideChapter>& chapters) {
  if (piece.startsWith(QLatin1String("```")))
    return piece;
  static const QRegularExpression link(QStringLiteral("(!?)\\[([^\\]]+)\\]\\(([^)#]*)(?:#[^)]*)?\\)"));
  QString text;
  qsizetype end = 0;
  for (auto found = link.globalMatch(piece); found.hasNext();) {
    const QRegularExpressionMatch match = found.next();
    const QString path = guidePathOf(chapter, match.captured(3));
    const bool isInside = match.captured(3).isEmpty() ||
                          std::ranges::find(chapters, path, &GuideChapter::path) != chapters.end();
    text += piece.mid(end, match.capturedStart() - end);
    if (!match.captured(1).isEmpty())
      text += QStringLiteral("[%1]").arg(match.captured(2));
    else if (isInside)
      text += match.captured(2);
    else
      text += withSource(match.captured(2), sourcePathOf(path));
    end = match.capturedEnd();
  }
  return text + piece.mid(end);
}

int levelOf(const QString& piece) {
  int level = 0;
  while (level < piece.size() && piece[level] == QLatin1Char('#'))
    ++level;
  return level;
}

} // namespace

std::vector<GuideChapter> guideChapters() {
  loadGuide();
  std::vector<GuideChapter> chapters;
  for (const Place& place : places) {
    QFile file(guideResource(QLatin1String(place.path)));
    [[maybe_unused]] const bool isOpen = file.open(QIODevice::ReadOnly);
    assert(isOpen && "the program carries its guide");
    chapters.push_back(
        {QLatin1String(place.id), QLatin1String(place.path), QString::fromUtf8(file.readAll())});
  }
  return chapters;
}

QString guideResource(const QString& path) {
  return QStringLiteral(":/guide/") + path;
}

QString guidePathOf(const GuideChapter& chapter, const QString& link) {
  const QString folder = chapter.path.contains(QLatin1Char('/'))
                             ? chapter.path.section(QLatin1Char('/'), 0, -2) + QLatin1Char('/')
                             : QString();
  return QDir::cleanPath(folder + link);
}

QString sourcePathOf(const QString& guidePath) {
  return QDir::cleanPath(QStringLiteral("app/guide/") + guidePath);
}

QString withSource(const QString& words, const QString& sourcePath) {
  return QStringLiteral("%1 (%2 in Limn's source)").arg(words, sourcePath);
}

QString guideText(const std::vector<GuideChapter>& chapters, const QString& words) {
  static const QRegularExpression space(QStringLiteral("\\s+"));
  const QStringList wanted = words.split(space, Qt::SkipEmptyParts);
  QStringList found;
  for (const GuideChapter& chapter : chapters) {
    QStringList above;    // headings that no piece was found below yet
    bool isNamed = false; // by the last heading, or the one right above it: all of its text is meant
    bool isBelowHeading = false;
    for (const QString& written : piecesOf(chapter.markdown)) {
      const QString piece = withoutLinks(written, chapter, chapters);
      const int level = levelOf(piece);
      const bool isFound = std::ranges::all_of(
          wanted, [&](const QString& word) { return piece.contains(word, Qt::CaseInsensitive); });
      if (level > 0) {
        erase_if(above, [level](const QString& heading) { return levelOf(heading) >= level; });
        above << piece;
        isNamed = isFound || (isNamed && isBelowHeading);
      } else if (isFound || isNamed) {
        found << above << piece;
        above.clear();
      }
      isBelowHeading = level > 0;
    }
  }
  return found.isEmpty() ? QString() : found.join(QStringLiteral("\n\n")) + QLatin1Char('\n');
}

} // namespace limn
