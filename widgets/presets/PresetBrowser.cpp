// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/presets/PresetBrowser.h"

#include "widgets/controls/SearchField.h"
#include "widgets/presets/PresetDelegates.h"
#include "widgets/presets/PresetFilter.h"
#include "widgets/presets/PresetPointer.h"
#include "widgets/theme/Icons.h"
#include "widgets/theme/Theme.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QPushButton>
#include <QScrollBar>
#include <QStackedWidget>
#include <QStandardItemModel>
#include <QString>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <string>

namespace limn {

PresetBrowser::PresetBrowser(QWidget* parent)
    : QWidget(parent), m_search(new SearchField(tr("Search presets"))), m_views(new QStackedWidget),
      m_list(new QTreeView), m_gallery(new QListView), m_switch(new QToolButton),
      m_delegate(new PresetDelegate(m_list)), m_nothing(new QLabel(tr("No preset matches"))),
      m_save(new QPushButton(tr("Save as preset…"))), m_delete(new QToolButton),
      m_model(new QStandardItemModel(this)), m_filtered(new PresetFilter(this)),
      m_flat(new FlatPresets(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  auto* top = new QHBoxLayout;
  top->setContentsMargins(8, 4, 8, 4);
  top->setSpacing(4);
  top->addWidget(m_search, 1);
  top->addWidget(m_switch);
  layout->addLayout(top);
  layout->addWidget(m_nothing);
  layout->addWidget(m_views, 1);
  m_views->addWidget(m_list);
  m_views->addWidget(m_gallery);
  layout->addWidget(makeButtons());
  makeList();
  makeGallery();
  setFocusProxy(m_list);
  connect(m_switch, &QAbstractButton::clicked, this, [this] {
    setGallery(m_switch->isChecked());
    emit galleryChosen(m_switch->isChecked());
  });

  m_nothing->setAlignment(Qt::AlignCenter);
  m_nothing->setForegroundRole(QPalette::PlaceholderText);
  m_nothing->setMargin(16);
  m_search->setToolTip(tr("Shows only presets whose name, modality or note holds these words (Ctrl+F)"));
  m_search->installEventFilter(this);
  connect(m_search, &QLineEdit::textChanged, this, &PresetBrowser::search);
  refill();
}

void PresetBrowser::makeList() {
  m_filtered->setSourceModel(m_model);
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
  // Lines that the edge cut are painted once they are whole: to move the pixels is not enough.
  connect(m_list->verticalScrollBar(), &QScrollBar::valueChanged, m_list->viewport(),
          qOverload<>(&QWidget::update));
  watch(*m_list);
}

void PresetBrowser::makeGallery() {
  m_flat->setSourceModel(m_filtered);
  m_gallery->setModel(m_flat);
  m_gallery->setItemDelegate(new PresetTile(m_gallery));
  m_gallery->setObjectName(QStringLiteral("presetGallery"));
  m_gallery->setViewMode(QListView::IconMode);
  m_gallery->setResizeMode(QListView::Adjust);
  m_gallery->setMovement(QListView::Static);
  m_gallery->setMouseTracking(true);
  m_gallery->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_gallery->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_gallery->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn); // tiles share a width that does not change
  watch(*m_gallery);
  m_switch->setCheckable(true);
  m_switch->setAutoRaise(true);
  m_switch->setAccessibleName(tr("Large pictures"));
  m_switch->setToolTip(tr("Shows the presets as large pictures instead of a list"));
}

void PresetBrowser::watch(QAbstractItemView& view) {
  view.setAccessibleName(tr("Presets"));
  view.installEventFilter(this);
  view.viewport()->installEventFilter(this);
  connect(new PresetPointer(view), &PresetPointer::pointedAt, this, &PresetBrowser::previewRequested);
  connect(&view, &QAbstractItemView::clicked, this, &PresetBrowser::choose);
  connect(view.selectionModel(), &QItemSelectionModel::currentChanged, this, &PresetBrowser::showButtons);
}

QAbstractItemView& PresetBrowser::view() const {
  return static_cast<QAbstractItemView&>(*m_views->currentWidget());
}

void PresetBrowser::setGallery(bool isGallery) {
  m_switch->setChecked(isGallery);
  m_views->setCurrentWidget(isGallery ? static_cast<QWidget*>(m_gallery) : m_list);
  setFocusProxy(m_views->currentWidget());
  mark();
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

// A list that loses the keyboard as it goes must not tell it to one half gone.
PresetBrowser::~PresetBrowser() {
  for (PresetPointer* pointer : findChildren<PresetPointer*>())
    pointer->disconnect(this);
}

void PresetBrowser::setPicture(const QString& name, const QImage& picture, bool showsNothing) {
  m_pictures[name] = {picture, showsNothing};
  showPresetPicture(*m_model, name, m_pictures[name]);
}

void PresetBrowser::clearPictures() {
  m_pictures.clear();
  refill();
}

void PresetBrowser::setVolumeOpen(bool isOpen) {
  m_views->setEnabled(isOpen);
  m_save->setEnabled(isOpen);
}

void PresetBrowser::refill() {
  const int scrolled = m_list->verticalScrollBar()->value();
  fillPresetModel(*m_model, groupedPresets(m_builtIn, m_own, m_standing), lookOf(palette()));
  for (const auto& [name, picture] : m_pictures)
    showPresetPicture(*m_model, name, picture);
  search(m_search->text());
  mark();
  m_switch->setIcon(themedIcon(QStringLiteral("view-names"), palette()));
  m_save->setIcon(themedIcon(QStringLiteral("preset-save"), palette()));
  m_delete->setIcon(themedIcon(QStringLiteral("delete"), palette()));
  showButtons();
  m_list->verticalScrollBar()->setValue(scrolled);
}

void PresetBrowser::setStanding(const PresetStanding& standing) {
  if (standing == m_standing)
    return;
  m_standing = standing;
  refill();
}

QStringList PresetBrowser::presets() const {
  QStringList names;
  for (const PresetGroup& group : groupedPresets(m_builtIn, m_own, m_standing))
    for (const ListedPreset& listed : group.presets)
      names << QString::fromStdString(listed.preset.name);
  return names;
}

void PresetBrowser::search(const QString& text) {
  m_filtered->search(text);
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

QModelIndex PresetBrowser::listed(const QString& name) const {
  const QModelIndexList found = m_filtered->match(m_filtered->index(0, 0), Qt::DisplayRole, name, 1,
                                                  Qt::MatchExactly | Qt::MatchRecursive);
  return name.isEmpty() || found.isEmpty() ? QModelIndex() : found.front();
}

void PresetBrowser::reveal(const QString& name) {
  if (!listed(name).isValid())
    m_search->clear();
  m_list->scrollTo(listed(name));
}

// The keyboard goes on from there, too.
void PresetBrowser::mark() {
  markPresetUse(*m_model, m_current, m_isModified ? PresetUse::modified : PresetUse::shown);
  const QModelIndex current = listed(m_current);
  m_list->setCurrentIndex(current);
  m_gallery->setCurrentIndex(m_flat->mapFromSource(current));
  showButtons();
}

void PresetBrowser::focusSearch() {
  m_search->setFocus(Qt::ShortcutFocusReason);
  m_search->selectAll();
}

void PresetBrowser::endSearch() {
  m_search->clear();
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
  const QModelIndex index = view().currentIndex();
  return index.data(presetRole::isOwn).toBool() ? index.data().toString() : QString();
}

void PresetBrowser::offerMenu(const QModelIndex& index, const QPoint& at) {
  if (!index.isValid() || index.data(presetRole::isGroup).toBool())
    return;
  const QString name = index.data().toString();
  const bool isFavourite = index.data(presetRole::isFavourite).toBool();
  const bool isModified = name == m_current && m_isModified;
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto add = [&](const QString& text, auto signal) {
    menu->addAction(text, menu, [this, name, signal] { emit(this->*signal)(name); });
  };
  add(isModified ? QObject::tr("Reset to this preset") : QObject::tr("Use"), &PresetBrowser::presetChosen);
  add(QObject::tr("Compare with the picture"), &PresetBrowser::compareRequested);
  menu->addAction(isFavourite ? QObject::tr("Remove from favourites") : QObject::tr("Add to favourites"),
                  menu, [this, name, isFavourite] { emit favouriteRequested(name, !isFavourite); });
  menu->addSeparator();
  add(QObject::tr("Duplicate…"), &PresetBrowser::duplicateRequested);
  add(QObject::tr("Export…"), &PresetBrowser::exportRequested);
  if (index.data(presetRole::isOwn).toBool()) {
    add(QObject::tr("Rename…"), &PresetBrowser::renameRequested);
    add(QObject::tr("Note…"), &PresetBrowser::noteRequested);
    addFolders(*menu, name);
    add(QObject::tr("Delete"), &PresetBrowser::deleteRequested);
  }
  menu->addSeparator();
  menu->addAction(QObject::tr("Copy name"), menu, [name] { QApplication::clipboard()->setText(name); });
  menu->popup(at);
}

void PresetBrowser::addFolders(QMenu& menu, const QString& name) {
  QMenu* folders = menu.addMenu(QObject::tr("Move to folder"));
  const auto known = std::ranges::find(m_own, name.toStdString(), &Preset::name);
  const std::string holds = known == m_own.end() ? std::string() : known->folder;
  const auto add = [&](const QString& text, const std::string& folder) {
    QAction* action = folders->addAction(
        text, folders, [this, name, folder] { emit folderRequested(name, QString::fromStdString(folder)); });
    action->setCheckable(true);
    action->setChecked(folder == holds);
  };
  add(QObject::tr("My presets"), {});
  for (const std::string& folder : foldersOf(m_own))
    add(QString::fromStdString(folder), folder);
  folders->addSeparator();
  folders->addAction(QObject::tr("New folder…"), folders, [this, name] { emit newFolderRequested(name); });
}

void PresetBrowser::showButtons() {
  const QString own = ownPresetInHand();
  m_delete->setEnabled(!own.isEmpty());
  m_delete->setToolTip(own.isEmpty() ? tr("Only presets of your own can be deleted: choose one first")
                                     : tr("Deletes the preset \"%1\"").arg(own));
}

bool PresetBrowser::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_list->viewport() || watched == m_gallery->viewport()) {
    if (event->type() == QEvent::Resize)
      layOutAgain();
    return handleRightClick(*event);
  }
  if (event->type() == QEvent::ContextMenu && watched == &view()) {
    const QModelIndex index = view().currentIndex();
    offerMenu(index, view().viewport()->mapToGlobal(view().visualRect(index).center()));
    return true;
  }
  if (event->type() != QEvent::KeyPress)
    return QWidget::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  if (watched == m_search)
    return handleSearchKey(key);
  return handleListKey(key);
}

// Rows and tiles follow the room that there is.
void PresetBrowser::layOutAgain() {
  m_delegate->layOutAgain();
  QMetaObject::invokeMethod(
      m_gallery, [this] { m_gallery->doItemsLayout(); }, Qt::QueuedConnection);
}

bool PresetBrowser::handleListKey(int key) {
  const QString own = ownPresetInHand();
  if (key == Qt::Key_Return || key == Qt::Key_Enter)
    choose(view().currentIndex());
  else if (key == Qt::Key_F)
    toggleFavourite(view().currentIndex());
  else if (key == Qt::Key_Delete && !own.isEmpty())
    emit deleteRequested(own);
  else if (key == Qt::Key_F2 && !own.isEmpty())
    emit renameRequested(own);
  else
    return false;
  return true;
}

void PresetBrowser::toggleFavourite(const QModelIndex& index) {
  if (index.isValid() && !index.data(presetRole::isGroup).toBool())
    emit favouriteRequested(index.data().toString(), !index.data(presetRole::isFavourite).toBool());
}

// A menu is about the row under the pointer; the one that is marked stays.
bool PresetBrowser::handleRightClick(const QEvent& event) {
  if (event.type() == QEvent::ContextMenu) {
    const auto& asked = static_cast<const QContextMenuEvent&>(event);
    offerMenu(view().indexAt(asked.pos()), asked.globalPos());
    return true;
  }
  const bool isButton =
      event.type() == QEvent::MouseButtonPress || event.type() == QEvent::MouseButtonRelease;
  return isButton && static_cast<const QMouseEvent&>(event).button() == Qt::RightButton;
}

bool PresetBrowser::handleSearchKey(int key) {
  const bool isGallery = &view() == m_gallery;
  const QModelIndex first =
      isGallery ? m_flat->index(0, 0) : m_filtered->index(0, 0, m_filtered->index(0, 0));
  if (key == Qt::Key_Escape && !m_search->text().isEmpty()) {
    m_search->clear();
    return true;
  }
  if (key == Qt::Key_Down && first.isValid()) {
    view().setCurrentIndex(first);
    view().setFocus(Qt::TabFocusReason);
    return true;
  }
  if ((key == Qt::Key_Return || key == Qt::Key_Enter) && first.isValid()) {
    view().setCurrentIndex(first);
    choose(first);
    emit searchEnded();
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
