// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetBrowser.h"

#include "widgets/Icons.h"
#include "widgets/Theme.h"
#include "widgets/presets/PresetDelegate.h"
#include "widgets/presets/PresetModel.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QStandardItemModel>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

namespace limn {

PresetBrowser::PresetBrowser(QWidget* parent)
    : QWidget(parent), m_search(new QLineEdit), m_list(new QTreeView), m_delegate(new PresetDelegate(m_list)),
      m_nothing(new QLabel(tr("No preset matches"))), m_save(new QPushButton(tr("Save as preset…"))),
      m_delete(new QToolButton), m_searchIcon(m_search->addAction(QIcon(), QLineEdit::LeadingPosition)),
      m_model(new QStandardItemModel(this)), m_filtered(new QSortFilterProxyModel(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* top = new QHBoxLayout;
  top->setContentsMargins(8, 4, 8, 4);
  top->addWidget(m_search);
  layout->addLayout(top);
  layout->addWidget(m_nothing);
  layout->addWidget(m_list, 1);
  layout->addWidget(makeButtons());
  makeList();

  m_nothing->setAlignment(Qt::AlignCenter);
  m_nothing->setForegroundRole(QPalette::PlaceholderText);
  m_nothing->setMargin(16);
  m_search->setPlaceholderText(tr("Search presets"));
  m_search->setClearButtonEnabled(true);
  m_search->setAccessibleName(tr("Search presets"));
  for (QToolButton* button : m_search->findChildren<QToolButton*>()) // Qt's own, without names
    button->setAccessibleName(button->defaultAction() == m_searchIcon ? tr("Search presets")
                                                                      : tr("Clear the search"));
  m_search->setToolTip(tr("Shows only presets whose name, modality or note holds these words (Ctrl+F)"));
  m_search->installEventFilter(this);
  connect(m_search, &QLineEdit::textChanged, this, &PresetBrowser::search);
  refill();
}

void PresetBrowser::makeList() {
  m_filtered->setSourceModel(m_model);
  m_filtered->setRecursiveFilteringEnabled(true);
  m_filtered->setFilterRole(presetRole::searchText);
  m_list->setModel(m_filtered);
  m_list->setItemDelegate(m_delegate);
  m_list->setObjectName(QStringLiteral("presetList"));
  m_list->setHeaderHidden(true);
  m_list->setRootIsDecorated(false);
  m_list->setIndentation(0);
  m_list->setItemsExpandable(false);
  m_list->setMouseTracking(true);
  m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_list->setAccessibleName(tr("Presets"));
  m_list->installEventFilter(this);
  m_list->viewport()->installEventFilter(this);
  // Lines that the edge cut are painted once they are whole: to move the pixels is not enough.
  connect(m_list->verticalScrollBar(), &QScrollBar::valueChanged, m_list->viewport(),
          qOverload<>(&QWidget::update));
  connect(m_list, &QAbstractItemView::clicked, this, &PresetBrowser::choose);
  connect(m_list->selectionModel(), &QItemSelectionModel::currentChanged, this, &PresetBrowser::showButtons);
}

QWidget* PresetBrowser::makeButtons() {
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->setSpacing(4);
  layout->addWidget(m_save, 1);
  layout->addWidget(m_delete);
  m_save->setToolTip(tr("Keeps the present curve and light under a name of your own"));
  m_save->setAccessibleName(tr("Save as preset"));
  m_delete->setAccessibleName(tr("Delete preset"));
  connect(m_save, &QAbstractButton::clicked, this, &PresetBrowser::saveRequested);
  connect(m_delete, &QAbstractButton::clicked, this, [this] { emit deleteRequested(ownPresetInHand()); });
  return row;
}

void PresetBrowser::setPresets(const std::vector<Preset>& builtIn, const std::vector<Preset>& own) {
  m_builtIn = builtIn;
  m_own = own;
  refill();
}

void PresetBrowser::setVolumeOpen(bool isOpen) {
  m_list->setEnabled(isOpen);
  m_save->setEnabled(isOpen);
}

void PresetBrowser::refill() {
  fillPresetModel(*m_model, m_builtIn, m_own, lookOf(palette()));
  search(m_search->text());
  mark();
  m_searchIcon->setIcon(themedIcon(QStringLiteral("search"), palette()));
  m_save->setIcon(themedIcon(QStringLiteral("preset-save"), palette()));
  m_delete->setIcon(themedIcon(QStringLiteral("delete"), palette()));
  showButtons();
}

void PresetBrowser::search(const QString& text) {
  // Every word must occur, in any order.
  QString pattern;
  for (const QString& word : text.split(QLatin1Char(' '), Qt::SkipEmptyParts))
    pattern += QStringLiteral("(?=.*%1)").arg(QRegularExpression::escape(word));
  m_filtered->setFilterRegularExpression(
      QRegularExpression(QLatin1Char('^') + pattern, QRegularExpression::CaseInsensitiveOption));
  m_list->expandAll();
  const bool nothing = m_filtered->rowCount() == 0 && !text.isEmpty();
  m_nothing->setVisible(nothing);
}

void PresetBrowser::setCurrent(const QString& name, bool isModified) {
  if (name == m_current && isModified == m_isModified)
    return;
  const bool isOther = name != m_current;
  m_current = name;
  m_isModified = isModified;
  if (isOther)
    mark();
  else
    markPresetUse(*m_model, name, isModified ? PresetUse::modified : PresetUse::shown);
}

// The keyboard goes on from there, too.
void PresetBrowser::mark() {
  markPresetUse(*m_model, m_current, m_isModified ? PresetUse::modified : PresetUse::shown);
  const QModelIndexList found = m_filtered->match(m_filtered->index(0, 0), Qt::DisplayRole, m_current, 1,
                                                  Qt::MatchExactly | Qt::MatchRecursive);
  m_list->setCurrentIndex(m_current.isEmpty() || found.isEmpty() ? QModelIndex() : found.front());
  showButtons();
}

void PresetBrowser::focusSearch() {
  m_search->setFocus(Qt::ShortcutFocusReason);
  m_search->selectAll();
}

void PresetBrowser::choose(const QModelIndex& index) {
  if (!index.isValid() || index.data(presetRole::isGroup).toBool())
    return;
  const QString chosen = index.data().toString();
  emit presetChosen(chosen);
  if (m_current != chosen) // it did not take effect, so the list must not say so
    mark();
}

QString PresetBrowser::ownPresetInHand() const {
  const QModelIndex index = m_list->currentIndex();
  return index.data(presetRole::isOwn).toBool() ? index.data().toString() : QString();
}

void PresetBrowser::offerMenu(const QModelIndex& index, const QPoint& at) {
  if (!index.isValid() || index.data(presetRole::isGroup).toBool())
    return;
  const QString name = index.data().toString();
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto add = [&](const QString& text, auto act) { menu->addAction(text, this, act); };
  if (name == m_current && m_isModified)
    add(tr("Reset to this preset"), [this, name] { emit presetChosen(name); });
  else
    add(tr("Use"), [this, name] { emit presetChosen(name); });
  menu->addSeparator();
  add(tr("Duplicate…"), [this, name] { emit duplicateRequested(name); });
  if (index.data(presetRole::isOwn).toBool()) {
    add(tr("Rename…"), [this, name] { emit renameRequested(name); });
    add(tr("Delete"), [this, name] { emit deleteRequested(name); });
  }
  menu->addSeparator();
  add(tr("Copy name"), [name] { QApplication::clipboard()->setText(name); });
  menu->popup(at);
}

void PresetBrowser::showButtons() {
  const QString own = ownPresetInHand();
  m_delete->setEnabled(!own.isEmpty());
  m_delete->setToolTip(own.isEmpty() ? tr("Only presets of your own can be deleted: choose one first")
                                     : tr("Deletes the preset \"%1\"").arg(own));
}

bool PresetBrowser::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_list->viewport()) {
    if (event->type() == QEvent::Resize)
      m_delegate->layOutAgain();
    return handleRightClick(*event);
  }
  if (event->type() == QEvent::ContextMenu && watched == m_list) {
    const QModelIndex index = m_list->currentIndex();
    offerMenu(index, m_list->viewport()->mapToGlobal(m_list->visualRect(index).center()));
    return true;
  }
  if (event->type() != QEvent::KeyPress)
    return QWidget::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (watched == m_search)
    return handleSearchKey(key);
  if (key == Qt::Key_Return || key == Qt::Key_Enter) {
    choose(m_list->currentIndex());
    return true;
  }
  if (key == Qt::Key_Delete && !ownPresetInHand().isEmpty()) {
    emit deleteRequested(ownPresetInHand());
    return true;
  }
  return false;
}

// A menu is about the row under the pointer; the one that is marked stays.
bool PresetBrowser::handleRightClick(const QEvent& event) {
  if (event.type() == QEvent::ContextMenu) {
    const auto& asked = static_cast<const QContextMenuEvent&>(event);
    offerMenu(m_list->indexAt(asked.pos()), asked.globalPos());
    return true;
  }
  const bool isButton =
      event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonRelease;
  return isButton && static_cast<const QMouseEvent&>(event).button() == Qt::RightButton;
}

bool PresetBrowser::handleSearchKey(int key) {
  const QModelIndex first = m_filtered->index(0, 0, m_filtered->index(0, 0));
  if (key == Qt::Key_Escape && !m_search->text().isEmpty()) {
    m_search->clear();
    return true;
  }
  if (key == Qt::Key_Down && first.isValid()) {
    m_list->setCurrentIndex(first);
    m_list->setFocus(Qt::TabFocusReason);
    return true;
  }
  if ((key == Qt::Key_Return || key == Qt::Key_Enter) && first.isValid()) {
    m_list->setCurrentIndex(first);
    choose(first);
    return true;
  }
  return false;
}

void PresetBrowser::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange)
    refill();
  QWidget::changeEvent(event);
}

} // namespace limn
