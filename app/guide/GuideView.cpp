// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guide/GuideView.h"

#include "widgets/theme/Theme.h"

#include <QAbstractTextDocumentLayout>
#include <QEvent>
#include <QImage>
#include <QScrollBar>
#include <QTextBlock>

#include <algorithm>

namespace limn {
namespace {

constexpr int margin = 24;
constexpr int widestPicture = 900;

QString styleOf(const ThemeColors& colors) {
  return QStringLiteral("h1 { font-size: x-large; margin-top: 32px; margin-bottom: 8px; }"
                        "h2 { font-size: large; margin-top: 24px; margin-bottom: 6px; }"
                        "h3 { font-size: medium; margin-top: 16px; margin-bottom: 4px; }"
                        "p { margin-top: 6px; margin-bottom: 6px; } li { margin-bottom: 4px; }"
                        "pre { white-space: pre-wrap; } a { color: %1; } code, pre { font-family: monospace; "
                        "background-color: %2; }"
                        "table { border-collapse: collapse; margin-top: 8px; margin-bottom: 8px; }"
                        "th, td { padding: 4px 12px 4px 4px; border-bottom: 1px solid %3; }"
                        "th { text-align: left; font-weight: bold; }")
      .arg(colors.accent.name(), colors.window.name(), colors.border.name());
}

} // namespace

GuideView::GuideView(QWidget* parent) : QTextBrowser(parent) {
  setAccessibleName(tr("Guide"));
  setOpenLinks(false);
  document()->setDocumentMargin(margin);
  m_page =
      guidePage(guideChapters(), [](const QString& path) { return QStringLiteral("qrc:/guide/") + path; });
  connect(this, &QTextBrowser::anchorClicked, this, [this](const QUrl& url) {
    m_left.push_back(placeAtTop());
    goTo(url.fragment());
    emit scrolled(); // also where it leads to what is shown
  });
  connect(verticalScrollBar(), &QScrollBar::valueChanged, this, &GuideView::scrolled);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // or the width would depend on the height
  m_layOut.setSingleShot(true);
  m_layOut.setInterval(0);
  connect(&m_layOut, &QTimer::timeout, this, &GuideView::layOut);
  layOut();
}

GuideView::Place GuideView::placeAtTop() const {
  const int at = headingAtTop(), value = verticalScrollBar()->value();
  return {at, at < 0 ? value : value - topOf(at)};
}

void GuideView::showPlace(const Place& place) {
  verticalScrollBar()->setValue((place.heading < 0 ? 0 : topOf(place.heading)) + place.beyond);
}

void GuideView::goBack() {
  if (m_left.empty())
    return;
  const Place left = m_left.back();
  m_left.pop_back();
  showPlace(left);
  emit scrolled();
}

// Anew where colours or the room for pictures change.
void GuideView::layOut() {
  const Place seen = placeAtTop();
  QString wanted;
  if (m_shown >= 0)
    wanted = m_hits[m_shown].selectedText();
  m_width = std::min(widestPicture, viewport()->width() - 2 * margin);
  document()->clear();
  document()->setDefaultStyleSheet(styleOf(themeColors(palette())));
  setHtml(m_page.body);
  m_places.clear();
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next())
    if (block.blockFormat().headingLevel() > 0)
      m_places.push_back(block.position());
  m_hits.clear();
  m_shown = -1;
  if (seen.heading >= 0)
    showPlace(seen);
  if (!wanted.isEmpty())
    look(wanted);
}

int GuideView::topOf(int heading) const {
  const QTextBlock block = document()->findBlock(m_places[heading]);
  return static_cast<int>(document()->documentLayout()->blockBoundingRect(block).top()) - margin / 2;
}

void GuideView::goTo(const QString& anchor) {
  const auto found = std::ranges::find(m_page.headings, anchor, &GuideHeading::anchor);
  if (found != m_page.headings.end())
    verticalScrollBar()->setValue(topOf(static_cast<int>(found - m_page.headings.begin())));
}

int GuideView::headingAtTop() const {
  const int seen = cursorForPosition({margin, margin}).position();
  const auto after = std::upper_bound(m_places.begin(), m_places.end(), seen);
  return static_cast<int>(after - m_places.begin()) - 1;
}

int GuideView::look(const QString& text) {
  const int from = cursorForPosition({margin, margin}).position();
  m_hits.clear();
  m_shown = -1;
  if (!text.isEmpty())
    for (QTextCursor at = document()->find(text, 0); !at.isNull(); at = document()->find(text, at))
      m_hits.push_back(at);
  if (!m_hits.empty()) {
    const auto first =
        std::ranges::find_if(m_hits, [from](const QTextCursor& hit) { return hit.selectionStart() >= from; });
    m_shown = first == m_hits.end() ? 0 : static_cast<int>(first - m_hits.begin());
  }
  mark();
  return hits();
}

int GuideView::step(int direction) {
  if (m_hits.empty())
    return 0;
  m_shown = (m_shown + direction + hits()) % hits();
  mark();
  return hitShown();
}

void GuideView::mark() {
  const ThemeColors colors = themeColors(palette());
  QList<QTextEdit::ExtraSelection> marks;
  for (int i = 0; i < hits(); ++i) {
    QTextEdit::ExtraSelection one;
    one.cursor = m_hits[i];
    const bool isShown = i == m_shown;
    one.format.setBackground(isShown ? colors.accent : colors.hover);
    one.format.setForeground(isShown ? colors.accentText : colors.text);
    one.format.setFontUnderline(true); // also where colours are not seen
    marks << one;
  }
  setExtraSelections(marks);
  if (m_shown < 0)
    return;
  QTextCursor place = m_hits[m_shown];
  place.clearSelection();
  setTextCursor(place); // where Tab and a screen reader go on
  const QRect seen = cursorRect(place);
  if (seen.top() < margin || seen.bottom() > viewport()->height() - margin)
    verticalScrollBar()->setValue(verticalScrollBar()->value() + seen.top() - viewport()->height() / 3);
}

QVariant GuideView::loadResource(int type, const QUrl& name) {
  if (type != QTextDocument::ImageResource || name.scheme() != QLatin1String("qrc"))
    return {}; // nothing comes from elsewhere
  // Scaled in few colours of its own it would be dotted.
  QImage picture =
      QImage(QLatin1Char(':') + name.path()).convertToFormat(QImage::Format_ARGB32_Premultiplied);
  const qreal ratio = devicePixelRatioF();
  const int widest = static_cast<int>(m_width * ratio);
  if (picture.width() > widest)
    picture = picture.scaledToWidth(widest, Qt::SmoothTransformation);
  picture.setDevicePixelRatio(ratio);
  return picture;
}

void GuideView::changeEvent(QEvent* event) {
  QTextBrowser::changeEvent(event);
  if (event->type() == QEvent::PaletteChange)
    m_layOut.start();
}

void GuideView::resizeEvent(QResizeEvent* event) {
  QTextBrowser::resizeEvent(event);
  if (std::min(widestPicture, viewport()->width() - 2 * margin) != m_width)
    m_layOut.start();
}

} // namespace limn
