// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/presets/Preset.h"

#include <QWidget>

#include <vector>

class QLabel;
class QLineEdit;
class QPushButton;
class QSortFilterProxyModel;
class QStandardItemModel;
class QToolButton;
class QTreeView;

namespace limn {

class PresetDelegate;

/// The presets as a searchable list, grouped: the user's own, then the built-in ones by modality. A click or
/// Enter chooses, a right click opens a menu and selects nothing; names are unique over both lists. The frame
/// marks the preset that is shown, wherever the keyboard is. It saves and deletes nothing itself.
class PresetBrowser : public QWidget {
  Q_OBJECT

public:
  explicit PresetBrowser(QWidget* parent = nullptr);

  /// Whether there is a volume; without one presets are only to be read.
  void setVolumeOpen(bool isOpen);

  void setPresets(const std::vector<Preset>& builtIn, const std::vector<Preset>& own);

  /// Marks a preset by name, without choosing it, as the one that the picture was made from, changed since or
  /// not; an unknown or empty name marks none. A choice by the user marks nothing by itself: its receiver
  /// answers with this where the preset took effect.
  void setCurrent(const QString& name, bool isModified = false);

  /// Puts the keyboard into the search field.
  void focusSearch();

  QSize sizeHint() const override { return {232, 480}; }

signals:
  void presetChosen(const QString& name);
  void saveRequested();
  /// A preset is to be kept as one of the user's own under another name.
  void duplicateRequested(const QString& name);
  /// Only for the user's own presets.
  void renameRequested(const QString& name);
  void deleteRequested(const QString& name);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void makeList();
  QWidget* makeButtons();
  void refill();
  void search(const QString& text);
  void mark();
  void offerMenu(const QModelIndex& index, const QPoint& at);
  void choose(const QModelIndex& index);
  QString ownPresetInHand() const;
  void showButtons();
  bool handleSearchKey(int key);
  bool handleRightClick(const QEvent& event);

  std::vector<Preset> m_builtIn;
  std::vector<Preset> m_own;
  QString m_current; ///< the preset in use
  bool m_isModified = false;
  QLineEdit* m_search;
  QTreeView* m_list;
  PresetDelegate* m_delegate;
  QLabel* m_nothing;
  QPushButton* m_save;
  QToolButton* m_delete;
  QAction* m_searchIcon;
  QStandardItemModel* m_model;
  QSortFilterProxyModel* m_filtered;
};

} // namespace limn
