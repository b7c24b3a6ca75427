// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/guide/GuideWindow.h"

#include "app/guide/GuideView.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QScreen>
#include <QShortcut>
#include <QSignalBlocker>
#include <QSplitter>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QWidget>

namespace limn {

namespace {

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

} // namespace

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
