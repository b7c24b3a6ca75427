// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/presets/PresetModel.h"

#include <QWidget>

#include <map>
#include <vector>

class QAbstractItemView;
class QLabel;
class QListView;
class QMenu;
class QPushButton;
class QStackedWidget;
class QStandardItemModel;
class QToolButton;
class QTreeView;

namespace limn {

class FlatPresets;
class PresetDelegate;
class PresetFilter;
class SearchField;

/// The presets, searchable, as a list in groups (PresetModel) or a gallery of large pictures in the same
/// order. A click or Enter chooses, a right click opens a menu and selects nothing; F makes a favourite, F2
/// renames, Delete deletes; names are unique over both lists. The frame marks the preset that is shown,
/// wherever the keyboard is. It saves and deletes nothing itself.
class PresetBrowser : public QWidget {
  Q_OBJECT

public:
  explicit PresetBrowser(QWidget* parent = nullptr);
  ~PresetBrowser() override;

  /// Whether there is a volume; without one presets are only to be read.
  void setVolumeOpen(bool isOpen);

  void setPresets(const std::vector<Preset>& builtIn, const std::vector<Preset>& own);

  /// Lists them in another order.
  void setStanding(const PresetStanding& standing);

  /// The names of all presets from top to bottom, whatever is searched for.
  QStringList presets() const;

  /// Marks a preset by name, without choosing it, as the one that the picture was made from, changed since or
  /// not; an unknown or empty name marks none. A choice by the user marks nothing by itself: its receiver
  /// answers with this where the preset took effect.
  void setCurrent(const QString& name, bool isModified = false);

  /// Lists a preset that was just made, and ends a search that hides it.
  void reveal(const QString& name);

  /// Shows a preset by what it makes of the volume that is open; `showsNothing` where there is nothing to
  /// see.
  void setPicture(const QString& name, const QImage& picture, bool showsNothing);
  /// Shows all presets by their curves again.
  void clearPictures();

  /// Whether they are shown as a gallery; as a list at first.
  void setGallery(bool isGallery);

  /// Puts the keyboard into the search field.
  void focusSearch();

  /// Empties it: all are listed.
  void endSearch();

  QSize sizeHint() const override { return {232, 480}; }

signals:
  void galleryChosen(bool isGallery);
  void presetChosen(const QString& name);
  /// The pointer rests on a preset, or the keyboard went to it: it is to be seen for a while. Empty: no more.
  void previewRequested(const QString& name);
  /// Enter in the search field chose; the keyboard has nothing more to do here.
  void searchEnded();
  void saveRequested();
  /// A preset is to be kept as one of the user's own under another name.
  void duplicateRequested(const QString& name);
  void exportRequested(const QString& name);
  /// A preset is to be seen beside what is shown.
  void compareRequested(const QString& name);
  void favouriteRequested(const QString& name, bool isFavourite);
  /// Only for the user's own presets.
  void renameRequested(const QString& name);
  void noteRequested(const QString& name);
  void folderRequested(const QString& name, const QString& folder); ///< empty: none
  void newFolderRequested(const QString& name);
  void deleteRequested(const QString& name);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void makeList();
  void makeGallery();
  void watch(QAbstractItemView& view);
  QAbstractItemView& view() const; ///< the one that is seen
  QWidget* makeButtons();
  void refill();
  void search(const QString& text);
  QModelIndex listed(const QString& name) const;
  void mark();
  void offerMenu(const QModelIndex& index, const QPoint& at);
  void addFolders(QMenu& menu, const QString& name);
  void choose(const QModelIndex& index);
  void toggleFavourite(const QModelIndex& index);
  QString ownPresetInHand() const;
  void showButtons();
  bool handleSearchKey(int key);
  bool handleListKey(int key);
  void layOutAgain();
  bool handleRightClick(const QEvent& event);

  std::vector<Preset> m_builtIn;
  std::vector<Preset> m_own;
  std::map<QString, PresetPicture> m_pictures; ///< by preset
  PresetStanding m_standing;
  QString m_current; ///< the preset in use
  bool m_isModified = false;
  SearchField* m_search;
  QStackedWidget* m_views;
  QTreeView* m_list;
  QListView* m_gallery;
  QToolButton* m_switch;
  PresetDelegate* m_delegate;
  QLabel* m_nothing;
  QPushButton* m_save;
  QToolButton* m_delete;
  QStandardItemModel* m_model;
  PresetFilter* m_filtered;
  FlatPresets* m_flat; ///< for the gallery
};

} // namespace limn
