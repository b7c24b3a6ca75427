// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guide/GuidePage.h"
#include "app/guide/GuideSearch.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QStringList>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextList>
#include <QTextTable>

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
    {"enhanced", "presets/enhanced.md"},
    {"light", "light.md"},
    {"cut", "cut.md"},
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

// What is looked for, of a piece and the headings that it stands under.
using IsWanted = std::function<bool(const QString& piece, const QStringList& headings)>;

QString textOf(const std::vector<GuideChapter>& chapters, const IsWanted& isWanted) {
  QStringList found;
  for (const GuideChapter& chapter : chapters) {
    QStringList headings;
    QStringList above;    // those of them that no piece was found below yet
    bool isNamed = false; // by the last heading, or the one right above it: all of its text is meant
    bool isBelowHeading = false;
    for (const QString& written : piecesOf(chapter.markdown)) {
      const QString piece = withoutLinks(written, chapter, chapters);
      const int level = levelOf(piece);
      if (level > 0)
        for (QStringList* list : {&headings, &above})
          erase_if(*list, [level](const QString& heading) { return levelOf(heading) >= level; });
      const bool isFound = isWanted(piece, headings);
      if (level > 0) {
        headings << piece;
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

using PictureAddress = std::function<QString(const QString&)>;

// As the forge names a heading: lower case, hyphens for spaces, nothing else.
QString slugOf(const QString& heading) {
  QString slug;
  for (const QChar c : heading.toLower())
    if ((c.unicode() < 128 && c.isLetterOrNumber()) || c == QLatin1Char('-') || c == QLatin1Char('_'))
      slug += c;
    else if (c == QLatin1Char(' '))
      slug += QLatin1Char('-');
  return slug;
}

QString tagged(const char* tag, const QString& text) {
  return QStringLiteral("<%1>%2</%1>").arg(QLatin1String(tag), text);
}

bool isCode(const QTextBlock& block) {
  const QTextBlockFormat format = block.blockFormat();
  return format.hasProperty(QTextFormat::BlockCodeFence) ||
         format.hasProperty(QTextFormat::BlockCodeLanguage);
}

/// Writes one chapter.
class ChapterWriter {
public:
  ChapterWriter(const GuideChapter& chapter, const std::vector<GuideChapter>& all,
                const PictureAddress& picture, GuidePage& page)
      : m_chapter(chapter), m_all(all), m_picture(picture), m_page(page) {}

  void write() {
    QTextDocument document;
    document.setMarkdown(m_chapter.markdown, QTextDocument::MarkdownDialectGitHub);
    writeFrame(*document.rootFrame());
    leave();
  }

private:
  void writeFrame(const QTextFrame& frame) {
    for (auto it = frame.begin(); !it.atEnd(); ++it)
      if (const auto* table = qobject_cast<QTextTable*>(it.currentFrame()))
        writeTable(*table);
      else if (it.currentBlock().isValid())
        writeBlock(it.currentBlock());
  }

  void writeTable(const QTextTable& table) {
    leave();
    QString rows;
    for (int row = 0; row < table.rows(); ++row) {
      QString cells;
      for (int column = 0; column < table.columns(); ++column) {
        QString cell;
        const QTextTableCell at = table.cellAt(row, column);
        for (auto it = at.begin(); !it.atEnd(); ++it)
          cell += inlineOf(it.currentBlock(), row == 0);
        cells += tagged(row == 0 ? "th" : "td", cell);
      }
      rows += tagged("tr", cells) + QLatin1Char('\n');
    }
    m_page.body += tagged("table", rows) + QLatin1Char('\n');
  }

  void writeBlock(const QTextBlock& block) {
    if (isCode(block)) {
      enter("pre");
      m_page.body += block.text().toHtmlEscaped() + QLatin1Char('\n');
      return;
    }
    const int level = block.blockFormat().headingLevel();
    const QString text = inlineOf(block, level > 0);
    if (const QTextList* list = block.textList()) {
      enter(list->format().style() == QTextListFormat::ListDecimal ? "ol" : "ul");
      m_page.body += tagged("li", text) + QLatin1Char('\n');
      return;
    }
    leave();
    if (level > 0)
      writeHeading(level, block.text(), text);
    else if (!text.isEmpty())
      m_page.body += tagged("p", text) + QLatin1Char('\n');
  }

  void writeHeading(int level, const QString& plain, const QString& text) {
    const QString anchor = level == 1 ? m_chapter.id : m_chapter.id + QLatin1Char('.') + slugOf(plain);
    m_page.headings.push_back({level, plain, anchor});
    m_page.body += QStringLiteral("<h%1 id=\"%2\">%3</h%1>\n").arg(level).arg(anchor, text);
  }

  // Lines of code and points of a list that follow each other stand in one element.
  void enter(const char* tag) {
    if (m_open == QLatin1String(tag))
      return;
    leave();
    m_open = QLatin1String(tag);
    m_page.body += QLatin1Char('<') + m_open + QLatin1Char('>');
  }

  void leave() {
    if (!m_open.isEmpty())
      m_page.body += QStringLiteral("</") + m_open + QStringLiteral(">\n");
    m_open.clear();
  }

  QString inlineOf(const QTextBlock& block, bool isHeading) const {
    QString html;
    for (auto it = block.begin(); !it.atEnd(); ++it)
      html += inlineOf(it.fragment(), isHeading);
    return html;
  }

  QString inlineOf(const QTextFragment& fragment, bool isHeading) const {
    const QTextCharFormat format = fragment.charFormat();
    if (format.isImageFormat()) {
      const QTextImageFormat image = format.toImageFormat();
      return QStringLiteral("<img src=\"%1\" alt=\"%2\">")
          .arg(m_picture(guidePathOf(m_chapter, image.name())),
               image.property(QTextFormat::ImageAltText).toString().toHtmlEscaped());
    }
    QString html = fragment.text().toHtmlEscaped();
    if (format.fontFixedPitch() || !format.fontFamilies().toStringList().isEmpty())
      html = tagged("code", html);
    if (format.fontItalic())
      html = tagged("i", html);
    if (format.fontWeight() >= QFont::DemiBold && !isHeading)
      html = tagged("b", html);
    return format.isAnchor() ? linked(html, format.anchorHref()) : html;
  }

  QString linked(const QString& html, const QString& to) const {
    const QString file = to.section(QLatin1Char('#'), 0, 0);
    const QString place = to.section(QLatin1Char('#'), 1);
    const QString path = file.isEmpty() ? m_chapter.path : guidePathOf(m_chapter, file);
    for (const GuideChapter& chapter : m_all)
      if (chapter.path == path)
        return QStringLiteral("<a href=\"#%1\">%2</a>")
            .arg(place.isEmpty() ? chapter.id : chapter.id + QLatin1Char('.') + place, html);
    return withSource(html, tagged("code", sourcePathOf(path).toHtmlEscaped()));
  }

  const GuideChapter& m_chapter;
  const std::vector<GuideChapter>& m_all;
  const PictureAddress& m_picture;
  GuidePage& m_page;
  QString m_open; ///< the element that goes on; empty: none
};

QByteArray contentsOf(const QString& path) {
  QFile file(guideResource(path));
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
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
  const QStringList written = tellingWordsOf(words);
  const QString exactly = textOf(chapters, [&](const QString& piece, const QStringList&) {
    return std::ranges::all_of(
        written, [&](const QString& word) { return piece.contains(word, Qt::CaseInsensitive); });
  });
  if (!exactly.isEmpty())
    return exactly;
  const QList<GuideWord> meant = guideWordsOf(words);
  return textOf(chapters, [&](const QString& piece, const QStringList& headings) {
    return tellsOf(piece, headings, meant);
  });
}

GuidePage guidePage(const std::vector<GuideChapter>& chapters, const PictureAddress& picture) {
  GuidePage page;
  for (const GuideChapter& chapter : chapters)
    ChapterWriter(chapter, chapters, picture, page).write();
  return page;
}

QString guideFile(const std::vector<GuideChapter>& chapters) {
  const GuidePage page = guidePage(chapters, [](const QString& path) {
    return QStringLiteral("data:image/png;base64,") + QString::fromLatin1(contentsOf(path).toBase64());
  });
  QString contents;
  for (const GuideHeading& heading : page.headings)
    if (heading.level <= 2)
      contents += QStringLiteral("<li class=\"level%1\"><a href=\"#%2\">%3</a></li>\n")
                      .arg(heading.level)
                      .arg(heading.anchor, heading.text.toHtmlEscaped());
  // Not with arg(): the style sheet has signs of percent.
  QString file = QString::fromUtf8(contentsOf(QStringLiteral("page.html")));
  return file.replace(QLatin1String("@contents"), contents).replace(QLatin1String("@body"), page.body);
}

} // namespace limn
