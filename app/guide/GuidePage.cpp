// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guide/GuidePage.h"

#include <QFile>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextList>
#include <QTextTable>

namespace limn {
namespace {

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
