// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guide/GuideWindow.h"

#include "widgets/theme/Theme.h"

#include <QAbstractTextDocumentLayout>
#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QScreen>
#include <QScrollBar>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTextBlock>
#include <QTextTable>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QWidget>

#include <algorithm>

namespace limn {
namespace {

constexpr int margin = 24;
constexpr int widestPicture = 900;
constexpr int tableRounding = 1; // pixels that a table may be wider than its page

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

constexpr QSize usualSize(1080, 760);
constexpr int rowPadding = 4; // above and below the words of the contents
constexpr int anchorRole = Qt::UserRole;

QToolButton* stepButton(const QString& text, const QString& tip) {
  auto* button = new QToolButton;
  button->setText(text);
  button->setAccessibleName(text);
  button->setToolTip(tip);
  button->setProperty("framed", true);
  return button;
}

// What is read as one: a paragraph, or from the first cell of a row of a table the whole row; nothing from
// its other cells.
QTextCursor pieceFrom(const QTextBlock& block) {
  QTextCursor piece(block);
  const QTextTable* table = piece.currentTable();
  if (!table) {
    piece.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
    return piece;
  }
  const QTextTableCell cell = table->cellAt(block.position());
  if (cell.column() == 0)
    piece.setPosition(table->cellAt(cell.row(), table->columns() - 1).lastPosition(),
                      QTextCursor::KeepAnchor);
  return piece;
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
  setLineWrapMode(QTextEdit::FixedPixelWidth);
  fitPage();
  m_layOut.setSingleShot(true);
  m_layOut.setInterval(0);
  connect(&m_layOut, &QTimer::timeout, this, &GuideView::layOut);
  layOut();
}

// As wide as can be without scrolling sideways.
void GuideView::fitPage() {
  const int width = viewport()->width() - tableRounding;
  if (width != lineWrapColumnOrWidth())
    setLineWrapColumnOrWidth(width);
}

int GuideView::roomForPictures() const {
  return std::min(widestPicture, lineWrapColumnOrWidth() - 2 * margin);
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
  m_width = roomForPictures();
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
  if (!m_looked.isEmpty())
    look(m_looked);
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
  m_looked = text;
  m_hits.clear();
  m_shown = -1;
  if (!text.isEmpty())
    for (QTextCursor at = document()->find(text, 0); !at.isNull(); at = document()->find(text, at))
      m_hits.push_back(at);
  if (m_hits.empty())
    m_hits = placesOf(guideWordsOf(text));
  if (!m_hits.empty()) {
    const auto first =
        std::ranges::find_if(m_hits, [from](const QTextCursor& hit) { return hit.selectionStart() >= from; });
    m_shown = first == m_hits.end() ? 0 : static_cast<int>(first - m_hits.begin());
  }
  mark();
  return hits();
}

std::vector<QTextCursor> GuideView::placesOf(const QList<GuideWord>& words) const {
  std::vector<QTextCursor> places;
  QStringList above; // the headings, from the chapter's on
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    const QTextCursor piece = pieceFrom(block);
    const QString text = piece.selectedText();
    const int level = block.blockFormat().headingLevel();
    if (level > 0)
      above = above.mid(0, level - 1);
    if (tellsOf(text, above, words)) {
      HeldName own;
      for (auto word = words.begin(); own.at < 0; ++word)
        own = heldName(text, *word);
      QTextCursor place(document());
      place.setPosition(piece.selectionStart() + static_cast<int>(own.at));
      place.setPosition(place.position() + static_cast<int>(own.length), QTextCursor::KeepAnchor);
      places.push_back(place);
    }
    if (level > 0)
      above << text;
  }
  return places;
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
  fitPage();
  if (roomForPictures() != m_width)
    m_layOut.start();
}

GuideWindow::GuideWindow(QWidget* parent)
    : QDialog(parent, Qt::Window), m_page(new GuideView(this)), m_contents(new QTreeWidget(this)) {
  setObjectName(QStringLiteral("guideWindow"));
  setWindowTitle(tr("Limn: the guide"));
  m_contents->setObjectName(QStringLiteral("guideContents"));
  m_contents->setHeaderHidden(true);
  m_contents->setAccessibleName(tr("Contents"));
  m_contents->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  fillContents();
  auto* right = new QWidget(this);
  auto* column = new QVBoxLayout(right);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeSearch());
  column->addWidget(m_page, 1);
  auto* both = new QSplitter(this);
  both->addWidget(m_contents);
  both->addWidget(right);
  both->setStretchFactor(1, 1);
  both->setSizes({300, 780});
  both->setChildrenCollapsible(false);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(both);
  connect(m_contents, &QTreeWidget::currentItemChanged, this,
          [this](const QTreeWidgetItem* item) { m_page->goTo(item->data(0, anchorRole).toString()); });
  connect(m_page, &GuideView::scrolled, this, &GuideWindow::noteScrolled);
  resize(usualSize.boundedTo(screen()->availableSize() * 0.9));
  m_page->setFocus();
}

void GuideWindow::fillContents() {
  QTreeWidgetItem* chapter = nullptr;
  for (const GuideHeading& heading : m_page->headings()) {
    if (heading.level > 2) {
      m_items << m_items.back();
      continue;
    }
    auto* item = heading.level == 1 ? new QTreeWidgetItem(m_contents) : new QTreeWidgetItem(chapter);
    if (heading.level == 1)
      chapter = item;
    item->setText(0, heading.text);
    item->setToolTip(0, heading.text);
    item->setData(0, anchorRole, heading.anchor);
    item->setSizeHint(0, QSize(0, m_contents->fontMetrics().height() + 2 * rowPadding));
    m_items << item;
  }
}

QWidget* GuideWindow::makeSearch() {
  auto* bar = new QWidget(this);
  m_search = new QLineEdit(bar);
  m_search->setObjectName(QStringLiteral("guideSearch"));
  m_search->setPlaceholderText(tr("Find in the guide (Ctrl+F)"));
  m_search->setAccessibleName(tr("Find in the guide"));
  m_search->setClearButtonEnabled(true);
  m_search->setMaximumWidth(360);
  m_found = new QLabel(bar);
  m_found->setObjectName(QStringLiteral("guideFound"));
  m_back = stepButton(tr("Back"), tr("To where the link was followed (Alt+Left)"));
  m_back->setObjectName(QStringLiteral("guideBack"));
  m_back->setEnabled(false);
  QToolButton* before = stepButton(tr("Previous"), tr("The place before (Shift+F3)"));
  QToolButton* next = stepButton(tr("Next"), tr("The next place (F3, Enter)"));
  auto* language = new QLabel(tr("The guide is written in English."), bar);
  language->setForegroundRole(QPalette::PlaceholderText);
  language->setVisible(QLocale().language() != QLocale::English && QLocale().language() != QLocale::C);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(12, 8, 12, 8);
  row->addWidget(m_back);
  row->addWidget(m_search, 1);
  row->addWidget(before);
  row->addWidget(next);
  row->addWidget(m_found);
  row->addStretch();
  row->addWidget(language);
  const auto step = [this](int direction) {
    m_page->step(direction);
    noteFound();
  };
  const auto onKey = [this](const QKeySequence& key, auto&& run) {
    connect(new QShortcut(key, this), &QShortcut::activated, this, run);
  };
  connect(m_search, &QLineEdit::textChanged, this, &GuideWindow::look);
  connect(m_back, &QToolButton::clicked, m_page, &GuideView::goBack);
  connect(before, &QToolButton::clicked, this, [step] { step(-1); });
  connect(next, &QToolButton::clicked, this, [step] { step(1); });
  onKey(Qt::Key_F3, [step] { step(1); });
  onKey(Qt::SHIFT | Qt::Key_F3, [step] { step(-1); });
  onKey(Qt::ALT | Qt::Key_Left, [this] { m_page->goBack(); });
  onKey(QKeySequence::Find, [this] {
    m_search->setFocus(Qt::ShortcutFocusReason);
    m_search->selectAll();
  });
  connect(m_search, &QLineEdit::returnPressed, this,
          [step] { step(QApplication::keyboardModifiers() & Qt::ShiftModifier ? -1 : 1); });
  return bar;
}

void GuideWindow::showPlace(const QString& anchor) {
  m_page->goTo(anchor);
}

void GuideWindow::look(const QString& words) {
  if (m_search->text() != words) {
    m_search->setText(words); // comes back here
    return;
  }
  m_page->look(words);
  noteFound();
}

void GuideWindow::noteFound() {
  m_found->setText(m_search->text().isEmpty() ? QString()
                   : m_page->hits() == 0      ? tr("not found")
                                              : tr("%1 of %2").arg(m_page->hitShown()).arg(m_page->hits()));
}

// The contents follow the page, and ask it for nothing.
void GuideWindow::noteScrolled() {
  m_back->setEnabled(m_page->canGoBack());
  const int at = m_page->headingAtTop();
  if (at < 0)
    return;
  const QSignalBlocker quiet(m_contents);
  m_contents->setCurrentItem(m_items[at]);
}

// Esc: one thing after the other.
void GuideWindow::reject() {
  if (m_search->text().isEmpty())
    return QDialog::reject();
  m_search->clear();
  m_page->setFocus();
}

namespace {

struct PanelPlace {
  const char* panel; ///< its object name, or its class
  const char* place;
};

constexpr PanelPlace panelPlaces[] = {
    {"presetDock", "panels.presets"},          {"historyDock", "panels.history"},
    {"shadingDock", "panels.properties"},      {"effectsDock", "panels.effects"},
    {"accuracyDock", "panels.accuracy"},       {"rayDock", "panels.ray"},
    {"curveDock", "panels.transfer-function"}, {"limn::EmptyPanel", "start"},
    {"limn::CompareView", "panels.picture"},   {"limn::PlaneDeck", "panels.slices"},
};

} // namespace

QString guidePlaceOf(const QWidget* focused) {
  for (const QWidget* part = focused; part; part = part->parentWidget())
    for (const PanelPlace& one : panelPlaces)
      if (part->objectName() == QLatin1String(one.panel) || part->inherits(one.panel))
        return QLatin1String(one.place);
  return QStringLiteral("start");
}

} // namespace limn
